#pragma once
#include <triangle.hpp>

namespace glassbox {

/// The float nearest to a number. Not inlined: of several numbers at once, g++ 12 takes the way to float and back for
/// none at all.
[[gnu::noinline]] inline double as_float(double number) { return static_cast<double>(static_cast<float>(number)); }

inline Vec3<double> as_float(const Vec3<double>& v) { return {as_float(v.x), as_float(v.y), as_float(v.z)}; }

inline Triangle<double> as_float(const Triangle<double>& triangle) {
    return {as_float(triangle.A), as_float(triangle.B), as_float(triangle.C)};
}

}  // namespace glassbox
