#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

namespace glassbox {

/// A character of UTF-8 text and how many bytes it takes; no code, and one byte, for a byte that begins no character.
struct Utf8Character {
    std::optional<char32_t> code;
    std::size_t size = 1;
};

/// The first character of a text that is not empty. RFC 3629 defines well-formed UTF-8.
Utf8Character first_character(std::string_view text);

/// How many columns of a terminal a text takes: one for each character.
std::size_t columns(std::string_view text);

}  // namespace glassbox
