#pragma once
#include <filesystem>
#include <vector>

#include "viewer/view.hpp"

namespace glassbox {

/// Reads the steps of a script file: one command per line, quotes around words with blanks, # begins a comment
/// (docs/viewer.md). Throws Error with file and line for an invalid command.
std::vector<ScriptStep> read_script(const std::filesystem::path& file);

}  // namespace glassbox
