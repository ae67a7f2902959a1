#pragma once
#include <string>

namespace glassbox {

/// A word of a command line as a shell reads it back: quoted if necessary, and printable, so that it can be copied from
/// one terminal and pasted into another.
std::string shell_word(const std::string& word);

}  // namespace glassbox
