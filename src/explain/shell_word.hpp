#pragma once
#include <string>

namespace glassbox {

/// A word of a command line as a shell reads it back: in quotes where it needs them.
std::string shell_word(const std::string& word);

}  // namespace glassbox
