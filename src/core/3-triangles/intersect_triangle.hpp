#pragma once
#include <crossing.hpp>
#include <ray.hpp>
#include <sides.hpp>

namespace glassbox {

namespace told {
struct Corners {};  ///< (A, B, C, D): the triangle as seen from the ray's start, and the ray's direction
struct Sides {};    ///< (a, b, c): the three side products, each named after the vertex opposite its edge
}  // namespace told

/// Where a ray meets a triangle by its side products. `is_inside(sides, probe)` says whether its line passes inside.
template <class Real, class IsInside, class Probe>
constexpr Crossing<Real> by_sides(const Ray<Real>& ray, const Triangle<Real>& triangle, const IsInside& is_inside,
                                  Probe& probe) {
    const Vec3<Real> D = ray.D;
    const Triangle<Real> seen = seen_from(ray.P, triangle);
    const Sides<Real> s = sides(D, seen);
    probe(told::Corners{}, seen, D);
    probe(told::Sides{}, s.a, s.b, s.c);
    const Truth<Real> passes_inside = is_inside(s, probe);
    if (!possibly(passes_inside)) return {};
    const Real t = plane_t(D, seen, s);
    return {passes_inside && t > Real(0), t};
}

/// The paper's test by Plücker coordinates.
struct Pluecker {
    constexpr bool operator==(const Pluecker&) const = default;

    template <class Real, class Probe>
    constexpr Crossing<Real> operator()(const Ray<Real>& ray, const Triangle<Real>& triangle, Probe& probe) const {
        return by_sides(
            ray, triangle, [](const Sides<Real>& s, Probe&) { return inside(s); }, probe);
    }
};

/// Where the ray meets the triangle. `rule` is Pluecker, Tolerance or MoellerTrumbore.
template <class Real, class TriangleRule, class Probe>
constexpr Crossing<Real> intersect(const Ray<Real>& ray, const Triangle<Real>& triangle, const TriangleRule& rule,
                                   Probe& probe) {
    probe(told::Tested{});
    return rule(ray, triangle, probe);
}

}  // namespace glassbox
