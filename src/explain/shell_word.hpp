#pragma once
#include <string>

namespace glassbox {

/// A word of a command line as a shell reads it back: in quotes where it needs them, and printable, so that it can be
/// copied from a terminal and pasted into one.
std::string shell_word(const std::string& word);

}  // namespace glassbox
