#pragma once
#include <string>

#include "explain/story.hpp"

namespace glassbox {

/// The story as readable text: UTF-8, lines of at most 100 columns; numbers to 6 digits.
std::string to_text(const Story& story);

}  // namespace glassbox
