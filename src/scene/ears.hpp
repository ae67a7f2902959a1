#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "scene/orientation.hpp"

namespace glassbox {

/// Cuts off ears, convex corners whose triangle is empty, and cuts the rest into a fan: a fallback for an outline that
/// crosses itself and so has no inside. Leaves out flat triangles. Takes about half a second at most: where thousands
/// of corners cross each other, the fan begins before the ears run out.
std::vector<std::array<std::size_t, 3>> cut_ears(std::span<const Point2> outline);

}  // namespace glassbox
