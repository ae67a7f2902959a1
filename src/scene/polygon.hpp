#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <vec3.hpp>

namespace glassbox {

/// Cuts a polygon of n ≥ 3 corners, all in one plane or nearly so, into n − 2 triangles that keep its sense of
/// rotation. A convex one becomes the fan (0,1,2), (0,2,3), …; from others the first ear is cut, and again, until three
/// corners are left. What is no polygon (edges that cross, all corners on a line) is cut somehow, into as many.
std::vector<std::array<std::size_t, 3>> triangulate(std::span<const Vec3<double>> polygon);

}  // namespace glassbox
