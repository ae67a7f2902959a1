#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace glassbox::learn {

/// What is not closed in a C++ file, or closes nothing. A compiler often notices only in another file, and blames that
/// one.
struct Unclosed {
    std::size_t line = 0, column = 0;  ///< of the brace, the comment or the text, counted from 1
    std::string words;                 ///< what is wrong with it, and what would be right
};

/// Returns the first thing in a file that is opened and never closed: a literal, a comment that swallows another, a
/// brace; or the brace that is one too many. If braces are unbalanced, indentation decides which one is at fault,
/// provided that this balances them. Returns none if all is closed, and for what every compiler reports in the right
/// place: an unclosed last comment, an #if.
std::optional<Unclosed> unclosed_in(std::string_view source);

}  // namespace glassbox::learn
