#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <vec3.hpp>

namespace glassbox {

/// Cuts a planar or nearly planar polygon into triangles of its corners that keep its sense of rotation. They fill its
/// inside without overlap, exactly as seen along the axis nearest to its normal. The polygon may touch itself. A convex
/// polygon becomes the fan (0,1,2), (0,2,3), …; one without area becomes nothing. A polygon whose edges cross has no
/// inside: it is cut somehow, into at most n − 2 triangles. A triangle stays as it is. Each triangle begins with its
/// least corner.
std::vector<std::array<std::size_t, 3>> triangulate(std::span<const Vec3<double>> polygon);

}  // namespace glassbox
