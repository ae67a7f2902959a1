#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include <ray.hpp>
#include <sphere.hpp>
#include <triangle.hpp>

#include "numerics/vector_size.hpp"

namespace glassbox {

/// std::ilogb, which takes ten times as long, of a number that is not negative.
inline int exponent(double x) {
    const auto bits = static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52);
    return bits > 0 && bits < 0x7FF ? bits - 0x3FF : std::ilogb(x);
}

/// The exponent e of a vector's largest coordinate, as in 2ᵉ; FP_ILOGB0 for the zero vector, FP_ILOGBNAN if it is not
/// finite.
template <class Real>
int exponent(const Vec3<Real>& a) {
    const auto size = [](const Real& x) { return std::abs(static_cast<double>(x)); };
    if (!is_finite(convert<double>(a))) return FP_ILOGBNAN;
    return exponent(std::max({size(a.x), size(a.y), size(a.z)}));
}

/// 2ⁿ a, in two steps, because 2ⁿ alone may overflow or underflow.
template <class Real>
Vec3<Real> scaled(const Vec3<Real>& a, int n) {
    return Real(std::ldexp(1.0, n - n / 2)) * (Real(std::ldexp(1.0, n / 2)) * a);
}

/// The exponents of numbers whose squares are far from overflow and underflow in any scalar: 3·2⁸² and 2⁻⁸⁰ are still
/// floats. Doubles alone go farther.
constexpr int ordinary_exponent = 40, ordinary_exponent_of_doubles = 400;

inline bool is_within(int exponent, int most) { return exponent >= -most && exponent <= most; }

// The core's normals, for surfaces of any size. Where squares or products could overflow or underflow, their vectors
// are first multiplied by powers of two, which changes no normal and loses no bit.

/// The unit normal of a sphere about the origin, at a point of it.
template <class Real>
Vec3<Real> unit_normal(const Sphere<Real>& sphere, const Vec3<Real>& point) {
    const int e = exponent(point);
    const bool as_it_is = is_within(e, ordinary_exponent) || e == FP_ILOGB0 || e == FP_ILOGBNAN;
    return normal(sphere, as_it_is ? point : scaled(point, -e));
}

template <class Real>
Vec3<Real> unit_normal(const Triangle<Real>& triangle) {
    const auto& [A, B, C] = convert<double>(triangle);
    // With a power of two or without, the bits are the same, but for coordinates below 2⁻⁶⁰⁰ of the largest.
    constexpr int most = std::is_same_v<Real, double> ? ordinary_exponent_of_doubles : ordinary_exponent;
    if (is_within(exponent(cross(B - A, C - A)), most)) return normal(triangle);
    // The difference of two halved coordinates does not overflow.
    const auto overflows = [](const Vec3<Real>& difference) { return !is_finite(convert<double>(difference)); };
    const bool too_large = overflows(triangle.B - triangle.A) || overflows(triangle.C - triangle.A);
    const auto edge = [&](const Vec3<Real>& from, const Vec3<Real>& to) {
        const Vec3<Real> difference = too_large ? Real(0.5) * to - Real(0.5) * from : to - from;
        const int e = exponent(difference);
        return e == FP_ILOGB0 ? difference : scaled(difference, -e);
    };
    const Vec3<Real> to_B = edge(triangle.A, triangle.B), to_C = edge(triangle.A, triangle.C);
    const int e = exponent(cross(convert<double>(to_B), convert<double>(to_C)));
    return normal(Triangle<Real>{{}, to_B, e == FP_ILOGB0 ? to_C : scaled(to_C, -e)});
}

/// The unit normal where a ray meets a surface at t.
template <class Real>
Vec3<Real> normal_at(const Ray<Real>& ray, const Real& t, const Sphere<Real>& sphere) {
    const int e = exponent(Vec3<Real>{sphere.r, sphere.r, sphere.r});
    const std::int64_t farthest = std::max(exponent(ray.P), exponent(sphere.C));  // at the origin the least int
    const bool is_far_off = farthest - 12 > e;
    // A small sphere far from the origin: relative to its centre, the point loses no digits to c.
    if (is_far_off || !is_within(e, ordinary_exponent))
        return unit_normal(Sphere<Real>{{}, sphere.r}, ray.P - sphere.C + t * ray.D);
    return normal(sphere, at(ray, t));
}
template <class Real>
Vec3<Real> normal_at(const Ray<Real>&, const Real&, const Triangle<Real>& triangle) {
    return unit_normal(triangle);
}

// Whether `normal_at` may have lost most of its digits, or all: then `exact_normal` has them.

/// The point is off by what P − c is rounded by, or t; more than 2⁻²³ of the radius is too much.
inline bool is_far_off(const Ray<double>& ray, const Sphere<double>& sphere) {
    return !(greatest_coordinate(ray.P - sphere.C) <= 0x1p30 * sphere.r);
}

/// t has not all its digits where it overflows or is subnormal, nor has tD for a sphere so small.
inline bool loses_digits(const Ray<double>& ray, double t, const Sphere<double>& sphere) {
    constexpr double least = 0x1p-960;
    const bool has_all = std::isfinite(t) && std::abs(t) > least && sphere.r > least;
    return !has_all || is_far_off(ray, sphere);
}

/// For slivers: where the sine of the angle between two edges is below about 2⁻²⁰.
inline bool loses_digits(const Ray<double>&, double, const Triangle<double>& triangle) {
    constexpr double least = 0x1p-20, smallest = 0x1p-960;
    const Vec3<double> to_B = triangle.B - triangle.A, to_C = triangle.C - triangle.A;
    const double n = greatest_coordinate(cross(to_B, to_C)),
                 sizes = greatest_coordinate(to_B) * greatest_coordinate(to_C);
    if (n > smallest && std::isfinite(sizes) && n > least * sizes) return false;
    if (!is_finite(to_B) || !is_finite(to_C)) return true;
    if (to_B == Vec3<double>{} || to_C == Vec3<double>{}) return false;  // no area, truly
    return !(greatest_coordinate(cross(scaled(to_B, -exponent(to_B)), scaled(to_C, -exponent(to_C)))) > least);
}

}  // namespace glassbox
