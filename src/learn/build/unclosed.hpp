#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace glassbox::learn {

/// What is not closed in a C++ file, or closes nothing. A compiler often notices in another file, and blames that one.
struct Unclosed {
    std::size_t line = 0, column = 0;  ///< of the brace, the comment or the text, counted from 1
    std::string words;                 ///< what is wrong with it, and what would be right
};

/// The first thing in a file that is opened and never closed: a text, a comment that swallows another, a brace; or the
/// brace that is one too many. Where braces do not come out even, indentation tells which it is, if that makes them
/// even. None if all is closed, and none for what every compiler tells at its place itself: a last comment, an #if.
std::optional<Unclosed> unclosed_in(std::string_view source);

}  // namespace glassbox::learn
