#pragma once
#include <string>
#include <string_view>

namespace glassbox {

/// Text from a file, a command line or a learner's program, fit for a line on a terminal: a '?' stands for each
/// character that the terminal would obey instead of showing (control characters, line ends too), for each that turns
/// the direction of what is written around it, and for each byte that is not UTF-8.
std::string printable(std::string_view text);

/// The same for a text of several lines: line feeds and tabs stay.
std::string printable_lines(std::string_view text);

}  // namespace glassbox
