#pragma once
#include <optional>

#include <ray.hpp>
#include <sides.hpp>
#include <sphere.hpp>
#include <triangle.hpp>

#include "numerics/unrounded.hpp"

// What doubles tell exactly, where nothing is rounded: of meshes on grids, coplanar and coincident surfaces. It saves
// exact arithmetic, which takes a hundred times as long.

namespace glassbox {

/// Which corners of a triangle have weights other than 0 where a ray meets it: the point lies between these.
struct Support {
    bool A = true, B = true, C = true;
};

inline Vec3<Unrounded> unrounded(const Vec3<double>& v) { return {Unrounded(v.x), Unrounded(v.y), Unrounded(v.z)}; }
inline Triangle<Unrounded> unrounded(const Triangle<double>& triangle) {
    return {unrounded(triangle.A), unrounded(triangle.B), unrounded(triangle.C)};
}

/// The side products, if nothing was rounded on the way to them: they are exact then.
inline std::optional<Sides<double>> unrounded_sides(const Ray<double>& ray, const Triangle<double>& triangle) {
    const Sides<Unrounded> s = sides(unrounded(ray.D), seen_from(unrounded(ray.P), unrounded(triangle)));
    if (!s.a.is_exact() || !s.b.is_exact() || !s.c.is_exact()) return {};
    return Sides<double>{s.a.value(), s.b.value(), s.c.value()};
}

inline Support support(const Sides<double>& exact) { return {exact.a != 0, exact.b != 0, exact.c != 0}; }

/// Whether a triangle has all corners of another one that its support names.
inline bool has_corners(const Triangle<double>& triangle, const Triangle<double>& other, const Support& support) {
    const auto has = [&](const Vec3<double>& V) { return V == triangle.A || V == triangle.B || V == triangle.C; };
    return (!support.A || has(other.A)) && (!support.B || has(other.B)) && (!support.C || has(other.C));
}

/// Whether all corners of both triangles lie in one plane, if that is seen without rounding: along an axis, or by the
/// volumes that the corners of one have above the other.
inline bool are_coplanar(const Triangle<double>& one, const Triangle<double>& other) {
    const auto flat = [&](double Vec3<double>::*k) {
        const double x = one.A.*k;
        return one.B.*k == x && one.C.*k == x && other.A.*k == x && other.B.*k == x && other.C.*k == x;
    };
    if (flat(&Vec3<double>::x) || flat(&Vec3<double>::y) || flat(&Vec3<double>::z)) return true;
    const auto is_in_plane = [&](const Vec3<double>& V) {
        const auto& [A, B, C] = seen_from(unrounded(V), unrounded(one));
        const Unrounded volume = side(A, B, C);
        return volume.is_exact() && volume.value() == 0;
    };
    return is_in_plane(other.A) && is_in_plane(other.B) && is_in_plane(other.C);
}

}  // namespace glassbox
