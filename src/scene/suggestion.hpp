#pragma once
#include <span>
#include <string>
#include <string_view>

namespace glassbox {

/// How many letters to add, drop, change or swap with their neighbour to turn one word into the other. Ignores case.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The advice for an unknown name: "did you mean 'radius'?", or, if none is near, "it must be one of 'center',
/// 'radius', 'color'".
std::string suggestion(std::string_view unknown, std::span<const std::string_view> known);

}  // namespace glassbox
