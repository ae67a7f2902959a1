#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace glassbox::script {

using Words = std::vector<std::string>;

/// A line's words, up to where a comment begins. A word that begins with a quote, single or double, goes on to the next
/// such quote, whatever blanks and # stand between them. Throws Error for a quote that is not closed.
Words words_of(std::string_view line);

}  // namespace glassbox::script
