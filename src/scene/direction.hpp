#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <vec3.hpp>

namespace glassbox {

/// Why a vector has no usable direction, as a phrase after its name: "is 0 in x, y and z; …"; empty if it has one.
/// Within the allowed range no square of a component over- or underflows.
inline std::string why_no_direction(const Vec3<double>& v) {
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) return "is not finite";
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (largest == 0) return "is 0 in x, y and z; it must have a direction";
    if (largest < 1e-150 || largest > 1e150)
        return fmt::format("has the size {}; its squares fit a double only from 1e-150 to 1e150", largest);
    return {};
}

}  // namespace glassbox
