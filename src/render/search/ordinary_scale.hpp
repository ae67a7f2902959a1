#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include <ray.hpp>
#include <sphere.hpp>
#include <triangle.hpp>

namespace glassbox {

/// A ray and a surface, their lengths multiplied by a power of two, and the ray's direction by another one: what was so
/// large or small that products overflow or underflow is of ordinary size, and no digit is lost. Any t of theirs, times
/// `per_t`, is that of those that were given.
template <class Shape>
struct AtOrdinaryScale {
    Ray<double> ray;
    Shape shape;
    double per_t;
};

namespace ordinary_scale {

inline double greatest(const Vec3<double>& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }
inline double greatest(const Sphere<double>& s) { return std::max(greatest(s.C), std::abs(s.r)); }
inline double greatest(const Triangle<double>& t) { return std::max({greatest(t.A), greatest(t.B), greatest(t.C)}); }

inline Sphere<double> scaled(const Sphere<double>& s, double by) { return {by * s.C, by * s.r}; }
inline Triangle<double> scaled(const Triangle<double>& t, double by) { return {by * t.A, by * t.B, by * t.C}; }

inline bool is_ordinary(double size) { return size > 0x1p-60 && size < 0x1p60; }

/// Whether a number keeps all its digits.
inline bool keeps(double x, double by) { return x == 0 || (std::abs(x * by) >= 0x1p-1022 && std::isfinite(x * by)); }
inline bool keeps(const Vec3<double>& v, double by) { return keeps(v.x, by) && keeps(v.y, by) && keeps(v.z, by); }
inline bool keeps(const Sphere<double>& s, double by) { return keeps(s.C, by) && keeps(s.r, by); }
inline bool keeps(const Triangle<double>& t, double by) { return keeps(t.A, by) && keeps(t.B, by) && keeps(t.C, by); }

}  // namespace ordinary_scale

/// Nothing if they are of ordinary size as they are, or cannot be multiplied so.
template <class Shape>
std::optional<AtOrdinaryScale<Shape>> at_ordinary_scale(const Ray<double>& ray, const Shape& shape) {
    using namespace ordinary_scale;
    const double length = std::max(greatest(ray.P), greatest(shape)), speed = greatest(ray.D);
    if ((is_ordinary(length) && is_ordinary(speed)) || !(length > 0 && speed > 0)) return {};
    const int e = std::ilogb(length), d = std::ilogb(speed);
    if (std::max(std::abs(e), std::abs(d)) > 1000 || std::abs(e - d) > 1000) return {};
    const double by = std::ldexp(1, -e), by_d = std::ldexp(1, -d);
    if (!keeps(ray.P, by) || !keeps(shape, by) || !keeps(ray.D, by_d)) return {};
    return AtOrdinaryScale<Shape>{{by * ray.P, by_d * ray.D}, scaled(shape, by), std::ldexp(1, e - d)};
}

}  // namespace glassbox
