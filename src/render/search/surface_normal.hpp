#pragma once
#include <algorithm>
#include <cmath>

#include <probe.hpp>
#include <ray.hpp>
#include <sphere.hpp>
#include <triangle.hpp>

namespace glassbox {

/// The exponent of a vector's largest coordinate, as of 2ᵉ; very small for zeros, very large for what is no number.
template <class Real>
int exponent(const Vec3<Real>& a) {
    const auto of = [](const Real& x) { return std::ilogb(static_cast<double>(x)); };
    if (!is_finite(convert<double>(a))) return FP_ILOGBNAN;
    return std::max({of(a.x), of(a.y), of(a.z)});
}

/// 2ⁿ a, in two steps, for 2ⁿ alone may be no number.
template <class Real>
Vec3<Real> scaled(const Vec3<Real>& a, int n) {
    return Real(std::ldexp(1.0, n - n / 2)) * (Real(std::ldexp(1.0, n / 2)) * a);
}

/// Is a vector's square far from overflow and underflow, in any scalar?
template <class Real>
bool has_ordinary_square(const Vec3<Real>& a) {
    constexpr int most = 40;  // 3·2⁸² and 2⁻⁸⁰ are still floats
    const int e = exponent(a);
    return e >= -most && e <= most;
}

// The core's normals, of surfaces of any size: where squares or products could overflow or underflow the vectors that
// they are of are first multiplied by powers of two, which changes no normal and costs no bit.

/// Of a sphere about the origin, at a point of it.
template <class Real>
Vec3<Real> unit_normal(const Sphere<Real>& sphere, const Vec3<Real>& point) {
    const int e = exponent(point);
    const bool as_it_is = has_ordinary_square(point) || e == FP_ILOGB0 || e == FP_ILOGBNAN;
    return normal(sphere, as_it_is ? point : scaled(point, -e));
}

template <class Real>
Vec3<Real> unit_normal(const Triangle<Real>& triangle) {
    const auto& [A, B, C] = convert<double>(triangle);
    if (has_ordinary_square(cross(B - A, C - A))) return normal(triangle);
    // Halves of coordinates do not overflow when they are subtracted.
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

/// Has t, and the way to the sphere, all the digits of a double? Not if they overflow or are subnormal.
template <class Real>
bool has_all_digits(const Real& t, const Sphere<Real>& sphere) {
    constexpr double least = 0x1p-960;
    const double as_double = std::abs(static_cast<double>(t));
    return std::isfinite(as_double) && as_double > least && static_cast<double>(sphere.r) > least;
}

/// Where a ray meets a sphere, as seen from its centre and in units of 2ᵉ that make all lengths ordinary: t is found
/// anew there, the root nearer to the t that is known. For where that has not all its digits.
template <class Real>
Vec3<Real> point_in_other_units(const Ray<Real>& ray, const Real& t, const Sphere<Real>& sphere) {
    const int halved = is_finite(convert<double>(ray.P - sphere.c)) ? 0 : 1;  // then the difference does not overflow
    const Vec3<Real> f = scaled(ray.P, -halved) - scaled(sphere.c, -halved);
    const Vec3<Real> r = scaled(Vec3<Real>{sphere.r, Real(0), Real(0)}, -halved);
    const int e = std::max(exponent(f), exponent(r)), e_of_D = exponent(ray.D);
    const Ray<Real> seen{scaled(f, -e), scaled(ray.D, -e_of_D)};
    const Silent silent;
    const Roots<Real> roots = Stable{}(seen, Sphere<Real>{{}, scaled(r, -e).x}, silent);
    if (!surely(roots.real)) return at(seen, -dot(seen.P, seen.D) / dot(seen.D, seen.D));  // as near as it comes
    const double known = std::ldexp(static_cast<double>(t), e_of_D - e - halved);
    const double t0 = static_cast<double>(roots.t0), t1 = static_cast<double>(roots.t1);
    const bool is_first = std::isfinite(known) ? std::abs(t0 - known) <= std::abs(t1 - known) : t0 > 0;
    return at(seen, is_first ? roots.t0 : roots.t1);
}

/// The unit normal where a ray meets a surface at t.
template <class Real>
Vec3<Real> normal_at(const Ray<Real>& ray, const Real& t, const Sphere<Real>& sphere) {
    if (!has_all_digits(t, sphere))
        return unit_normal(Sphere<Real>{{}, sphere.r}, point_in_other_units(ray, t, sphere));
    const int e = exponent(Vec3<Real>{sphere.r, sphere.r, sphere.r});
    const bool is_far_off = std::max(exponent(ray.P), exponent(sphere.c)) - 12 > e;
    // A small sphere far from the origin: as seen from its centre, where it loses none of its digits to c.
    if (is_far_off || e < -40 || e > 40) return unit_normal(Sphere<Real>{{}, sphere.r}, ray.P - sphere.c + t * ray.D);
    return normal(sphere, at(ray, t));
}
template <class Real>
Vec3<Real> normal_at(const Ray<Real>&, const Real&, const Triangle<Real>& triangle) {
    return unit_normal(triangle);
}

}  // namespace glassbox
