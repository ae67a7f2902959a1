#pragma once
#include <algorithm>
#include <cmath>

#include <vec3.hpp>

namespace glassbox {

// Norms without a root, for bounds.

/// The size of the greatest coordinate.
inline double greatest_coordinate(const Vec3<double>& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}
/// The sum of the coordinates' sizes.
inline double sum_of_sizes(const Vec3<double>& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

}  // namespace glassbox
