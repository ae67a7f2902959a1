#pragma once
#include <algorithm>
#include <limits>

#include <ray.hpp>
#include <sides.hpp>
#include <sphere.hpp>

#include <magnitude.hpp>

namespace glassbox {

/// The largest absolute values, axis by axis, of the starts and directions of all rays to be traced.
struct RayBounds {
    Vec3<double> P, D;
};

/// The bounds extended by one more ray.
inline RayBounds including(const RayBounds& reach, const Ray<double>& ray) {
    const auto larger = [](const Vec3<double>& a, const Vec3<double>& b) {
        return Vec3<double>{std::max(a.x, std::abs(b.x)), std::max(a.y, std::abs(b.y)), std::max(a.z, std::abs(b.z))};
    };
    return {larger(reach.P, ray.P), larger(reach.D, ray.D)};
}

// A-priori filters: bounds, computed once per surface, on the rounding error of the doubles that decide its test, for
// any ray within reach. They cost the inner loop a comparison or two. Where numbers are so large or small that overflow
// or underflow could matter, the bounds are infinite and decide nothing.

namespace filter {

inline constexpr double u = 0x1p-53;
inline constexpr double never = std::numeric_limits<double>::infinity();

/// Whether products of seven numbers of that size neither overflow nor underflow.
constexpr bool is_ordinary(double size) { return size > 0x1p-100 && size < 0x1p100; }

inline double greatest(const Vec3<double>& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Bounds the error of the three side products. With a = A − P, b = B − P, s = D·(b × a), and S the same sum over
/// absolute values, every term is rounded at most seven times, so |ŝ − s| ≤ 7u S + O(u²) < 8u S. S is largest where all
/// coordinates are: at |A| + |P|, |D|.
inline double sides_error(const Triangle<double>& triangle, const RayBounds& reach) {
    // The difference of two magnitudes is their sum, so `seen_from` gives |A| + |P|.
    const Triangle<Magnitude> seen = seen_from(convert<Magnitude>(reach.P), convert<Magnitude>(triangle));
    const Sides<Magnitude> S = sides(convert<Magnitude>(reach.D), seen);
    const double coordinate =
        std::max({greatest(triangle.A), greatest(triangle.B), greatest(triangle.C), greatest(reach.P)});
    const double size = std::max({S.a.size, S.b.size, S.c.size});
    if (!is_ordinary(greatest(reach.D)) || !(coordinate < 0x1p100) || !(size > 0x1p-900)) return never;
    return 9 * u * size;  // 9 instead of 8: this sum is itself rounded
}

/// Bounds the error of the discriminant (v·D)² − D²(v² − r²), by either rule. Relative errors of a few u in each of v,
/// v·D, v·v and D·D change it by at most 32u D²(|v|² + r²) + O(u²): 20u in Textbook, 32u in Stable, where
/// l = f + (b/a)d is off by 11u|f|.
inline double discriminant_error(const Sphere<double>& sphere, const RayBounds& reach) {
    const auto [cx, cy, cz] = sphere.C;
    const Vec3<double> v{std::abs(cx) + reach.P.x, std::abs(cy) + reach.P.y, std::abs(cz) + reach.P.z};
    const double D2 = dot(reach.D, reach.D), v2 = dot(v, v), r2 = sphere.r * sphere.r;
    if (!is_ordinary(greatest(reach.D)) || !is_ordinary(greatest(v)) || !is_ordinary(sphere.r)) return never;
    return 40 * u * D2 * (v2 + r2);
}

/// Bounds the error of D·A, A seen from the ray's start: how far ahead a vertex is, in units of length |D|. Every term
/// is rounded at most four times.
inline double distance_error(const Triangle<double>& triangle, const RayBounds& reach) {
    const auto& [A, B, C] = seen_from(convert<Magnitude>(reach.P), convert<Magnitude>(triangle));
    const Vec3<Magnitude> D = convert<Magnitude>(reach.D);
    const double size = std::max({dot(D, A).size, dot(D, B).size, dot(D, C).size});
    if (!is_ordinary(greatest(reach.D)) || !is_ordinary(size)) return never;
    return 6 * u * size;
}

/// Bounds the error of v² − r², which says whether the ray starts outside the sphere: 6u(|v|² + r²) + O(u²).
inline double power_error(const Sphere<double>& sphere, const RayBounds& reach) {
    const Vec3<Magnitude> v = convert<Magnitude>(reach.P) - convert<Magnitude>(sphere.C);
    if (!is_ordinary(greatest(reach.P) + greatest(sphere.C)) || !is_ordinary(sphere.r)) return never;
    return 8 * u * (dot(v, v).size + sphere.r * sphere.r);
}

/// Error bounds on the numbers that decide a sphere's test.
struct SphereErrors {
    double discriminant = never, power = never;
};

/// Error bounds on the numbers that decide a triangle's test.
struct TriangleErrors {
    double side = never, distance = never;
};

inline SphereErrors errors(const Sphere<double>& sphere, const RayBounds& reach) {
    return {discriminant_error(sphere, reach), power_error(sphere, reach)};
}

inline TriangleErrors errors(const Triangle<double>& triangle, const RayBounds& reach) {
    return {sides_error(triangle, reach), distance_error(triangle, reach)};
}

}  // namespace filter

}  // namespace glassbox
