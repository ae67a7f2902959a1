#pragma once
#include <filesystem>
#include <vector>

#include "viewer/view.hpp"

namespace glassbox {

/// The steps of a script file: a command a line, quotes around what has blanks, # begins a comment (docs/viewer.md).
/// Throws Error with file and line for a command that makes no sense.
std::vector<ScriptStep> read_script(const std::filesystem::path& file);

}  // namespace glassbox
