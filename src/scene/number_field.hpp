#pragma once
#include <string_view>

#include "scene/error.hpp"

namespace glassbox {

/// The number in a field of a table: decimal or hexadecimal, `nan` and `inf` allowed; spaces around it do not count.
/// Throws Error with its place for what is no number, or too large for a double.
double read_number(std::string_view field, const Place& place);

}  // namespace glassbox
