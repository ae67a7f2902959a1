#pragma once
#include <string>

#include "learn/course/exercise.hpp"

namespace glassbox::learn {

/// Returns the header that a learner begins with: our solution, with each body to be written replaced by a line that
/// fails and names it. A function's last hint is its body, but for comments. Throws Error, at the function's place in
/// exercise.toml, if the solution does not have that body.
std::string starter_from(const std::string& solution, const Exercise& exercise, const std::string& header);

}  // namespace glassbox::learn
