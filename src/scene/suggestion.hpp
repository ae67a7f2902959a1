#pragma once
#include <span>
#include <string>
#include <string_view>

namespace glassbox {

/// How many letters must be added, dropped, changed or swapped with their neighbour to make one word of the other.
/// Capitals count as small letters.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// What to say to somebody who wrote a name that is not known: "did you mean 'radius'?", or, if none is near,
/// "it must be one of 'center', 'radius', 'color'".
std::string suggestion(std::string_view unknown, std::span<const std::string_view> known);

}  // namespace glassbox
