#pragma once
#include <filesystem>
#include <string>

namespace glassbox {

/// The file that SCENE means: the path as typed, or else one of the scenes that come with Glassbox ("levental-2014",
/// "levental-2014.toml", "scenes/levental-2014.toml"). Throws Error, with similar names, for a name that is neither.
std::filesystem::path scene_path(const std::string& typed);

/// The word that means this file: its name, if it comes with Glassbox and no file here has that name; else its path.
std::string scene_word(const std::filesystem::path& file);

/// The folder of the scenes that come with Glassbox: beside the installed program, or in the source tree that it was
/// built in. Empty if neither exists.
std::filesystem::path shipped_scenes();

}  // namespace glassbox
