#pragma once
#include <algorithm>
#include <cmath>

#include <sphere.hpp>
#include <triangle.hpp>

#include "numerics/vector_size.hpp"

namespace glassbox {

// Surfaces multiplied by a power of two: no digit is lost where `keeps_digits` holds.

/// No coordinate of it is larger.
inline double greatest_coordinate(const Sphere<double>& s) { return greatest_coordinate(s.C) + s.r; }
inline double greatest_coordinate(const Triangle<double>& t) {
    return std::max({greatest_coordinate(t.A), greatest_coordinate(t.B), greatest_coordinate(t.C)});
}

inline Sphere<double> scaled(const Sphere<double>& s, double by) { return {by * s.C, by * s.r}; }
inline Triangle<double> scaled(const Triangle<double>& t, double by) { return {by * t.A, by * t.B, by * t.C}; }

/// Whether multiplying by a power of two loses no digit below the least number, and nothing above the greatest.
inline bool keeps_digits(double x, double by) {
    return x == 0 || (std::abs(x * by) >= 0x1p-1022 && std::isfinite(x * by));
}
inline bool keeps_digits(const Vec3<double>& v, double by) {
    return keeps_digits(v.x, by) && keeps_digits(v.y, by) && keeps_digits(v.z, by);
}
inline bool keeps_digits(const Sphere<double>& s, double by) { return keeps_digits(s.C, by) && keeps_digits(s.r, by); }
inline bool keeps_digits(const Triangle<double>& t, double by) {
    return keeps_digits(t.A, by) && keeps_digits(t.B, by) && keeps_digits(t.C, by);
}

}  // namespace glassbox
