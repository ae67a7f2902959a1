#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <vec3.hpp>

namespace glassbox {

/// Cuts a polygon, all in one plane or nearly so, into triangles of its corners that keep its sense of rotation. What
/// it goes around is filled without overlap, to the bit as it is seen along the axis nearest to its normal. It may
/// touch itself. A convex one becomes the fan (0,1,2), (0,2,3), …; one without area, nothing. Where edges cross there
/// is no inside: it is cut somehow, into n − 2 at most. A triangle stays as it is. The first corner of each is the
/// least.
std::vector<std::array<std::size_t, 3>> triangulate(std::span<const Vec3<double>> polygon);

}  // namespace glassbox
