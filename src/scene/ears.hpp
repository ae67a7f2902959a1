#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "scene/orientation.hpp"

namespace glassbox {

/// Cuts off ears, corners that jut out and whose triangle is empty, and what remains into a fan: an answer for an
/// outline that crosses itself and so has no inside. Flat triangles are left out. It takes half a second or so at most:
/// where thousands of corners cross each other the fan begins before there are no more ears.
std::vector<std::array<std::size_t, 3>> cut_ears(std::span<const Point2> outline);

}  // namespace glassbox
