#pragma once
#include <cmath>

#include <crossing.hpp>
#include <not_written.hpp>
#include <pluecker.hpp>
#include <ray.hpp>

namespace glassbox {

namespace told {
struct Corners {};  ///< (A, B, C, D): the triangle as seen from the ray's start, and the ray's direction
struct Sides {};    ///< (a, b, c): the three side products, each named after the vertex opposite its edge
struct Deficit {};  ///< (a+b+c, | |a+b+c| − (|a|+|b|+|c|) |): the sum of the sides, and how far their signs disagree
}  // namespace told

/// A triangle with its vertices counter-clockwise as seen from the side that its normal points to.
template <class Real>
struct Triangle {
    Vec3<Real> A, B, C;
};

/// The same triangle in another scalar.
template <class To, class From>
constexpr Triangle<To> convert(const Triangle<From>& triangle) {
    return {convert<To>(triangle.A), convert<To>(triangle.B), convert<To>(triangle.C)};
}

/// The unit normal (B − A) × (C − A) / |…|; not a number for a triangle without area.
template <class Real>
Vec3<Real> normal(const Triangle<Real>& triangle) {
    return not_written<Vec3<Real>>("normal");
}

/// The triangle moved so that P becomes the origin.
template <class Real>
constexpr Triangle<Real> seen_from(const Vec3<Real>& P, const Triangle<Real>& triangle) {
    return not_written<Triangle<Real>>("seen_from");
}

/// The side products of a ray from the origin along D with the edges BC, CA and AB. Each is the weight of the vertex
/// opposite its edge: it is 0 on that edge, and the other two are 0 at that vertex.
template <class Real>
struct Sides {
    Real a, b, c;
};

template <class Real>
constexpr Sides<Real> sides(const Vec3<Real>& D, const Triangle<Real>& triangle) {
    return not_written<Sides<Real>>("sides");
}

/// Where a ray from the origin along D crosses the triangle's plane: the hit point is the weighted mean of the
/// vertices, (aA + bB + cC) / (a + b + c) = tD, and its component along D is t.
template <class Real>
constexpr Real plane_t(const Vec3<Real>& D, const Triangle<Real>& triangle, const Sides<Real>& weights) {
    return not_written<Real>("plane_t");
}

/// The paper's test (its section 1.1.2): all three side products ≥ 0 or all ≤ 0, and not all 0. Edges and vertices
/// belong to the triangle. A triangle seen edge-on, or without area, has three zeros and is never hit.
struct Pluecker {
    constexpr bool operator==(const Pluecker&) const = default;

    template <class Real, class Probe>
    constexpr Crossing<Real> operator()(const Ray<Real>& ray, const Triangle<Real>& triangle, Probe& probe) const {
        return not_written<Crossing<Real>>("Pluecker");
    }
};

/// What the paper's program does instead: it accepts where | |a+b+c| − (|a|+|b|+|c|) | is below an absolute tolerance.
/// That difference is twice the smaller of the positive and the negative part of the sum, in units of length² |D|: a
/// small triangle accepts nearly every ray, and a large one rejects true hits because of rounding alone.
struct Tolerance {
    double tolerance = 10.0;

    constexpr bool operator==(const Tolerance&) const = default;

    template <class Real, class Probe>
    constexpr Crossing<Real> operator()(const Ray<Real>& ray, const Triangle<Real>& triangle, Probe& probe) const {
        using std::abs;
        const Vec3<Real> D = ray.D;
        const Triangle<Real> seen = seen_from(ray.P, triangle);
        const Sides<Real> s = sides(D, seen);
        probe(told::Corners{}, seen, D);
        probe(told::Sides{}, s.a, s.b, s.c);
        const Real zero(0);
        const Real sum = s.a + s.b + s.c;
        const Real deficit = abs(abs(sum) - (abs(s.a) + abs(s.b) + abs(s.c)));
        probe(told::Deficit{}, sum, deficit);
        const auto inside = sum != zero && deficit < static_cast<Real>(tolerance);
        if (!possibly(inside)) return {};
        const Real t = plane_t(D, seen, s);
        return {inside && t > zero, t};
    }
};

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

/// Where the ray meets the triangle. `rule` is Pluecker, Tolerance or MoellerTrumbore.
template <class Real, class TriangleRule, class Probe>
constexpr Crossing<Real> intersect(const Ray<Real>& ray, const Triangle<Real>& triangle, const TriangleRule& rule,
                                   Probe& probe) {
    probe(told::Tested{});
    return rule(ray, triangle, probe);
}

}  // namespace glassbox
