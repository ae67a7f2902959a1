#pragma once
#include <string>
#include <string_view>

namespace glassbox {

/// Makes text from a file, a command line or a learner's program safe to show in a terminal line: puts '?' for each
/// character that the terminal would obey instead of showing (control characters, line ends too), for each that changes
/// the direction of the text around it, and for each byte that is not UTF-8.
std::string printable(std::string_view text);

/// The same for a text of several lines: line feeds and tabs stay.
std::string printable_lines(std::string_view text);

}  // namespace glassbox
