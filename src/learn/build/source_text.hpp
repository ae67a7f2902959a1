#pragma once
#include <cctype>

namespace glassbox::learn {

/// Whether the character is one of a word in C++: of a name, a keyword or a number.
inline bool in_a_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

}  // namespace glassbox::learn
