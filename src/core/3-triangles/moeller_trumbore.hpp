#pragma once
#include <crossing.hpp>
#include <ray.hpp>
#include <triangle.hpp>

namespace glassbox {

/// Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection" (1997), without culling: solves
/// P + tD = A + u(B − A) + v(C − A) by Cramer's rule. Two triangles that share an edge do not compute opposite numbers.
struct MoellerTrumbore {
    constexpr bool operator==(const MoellerTrumbore&) const = default;

    template <class Real, class Probe>
    constexpr Crossing<Real> operator()(const Ray<Real>& ray, const Triangle<Real>& triangle, Probe&) const {
        const auto& [A, B, C] = triangle;
        const Real zero(0), one(1);
        const Vec3<Real> E1 = B - A;
        const Vec3<Real> E2 = C - A;
        const Vec3<Real> p = cross(ray.D, E2);
        const Real determinant = dot(p, E1);
        if (!possibly(determinant != zero)) return {};
        const Vec3<Real> T = ray.P - A;
        const Real u = dot(p, T) / determinant;
        const Vec3<Real> q = cross(T, E1);
        const Real v = dot(q, ray.D) / determinant;
        const auto inside = determinant != zero && u >= zero && v >= zero && u + v <= one;
        if (!possibly(inside)) return {};
        const Real t = dot(q, E2) / determinant;
        return {inside && t > zero, t};
    }
};

}  // namespace glassbox
