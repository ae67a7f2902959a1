#pragma once
#include <pluecker.hpp>
#include <triangle.hpp>
#include <truth.hpp>

namespace glassbox {

/// The triangle moved so that P becomes the origin.
template <class Real>
constexpr Triangle<Real> seen_from(const Vec3<Real>& P, const Triangle<Real>& triangle) {
    return {triangle.A - P, triangle.B - P, triangle.C - P};
}

/// The side products of a ray from the origin along D with the edges BC, CA and AB. Each is the weight of the vertex
/// opposite its edge: it is 0 on that edge, and the other two are 0 at that vertex.
template <class Real>
struct Sides {
    Real a, b, c;
};

template <class Real>
constexpr Sides<Real> sides(const Vec3<Real>& D, const Triangle<Real>& triangle) {
    const auto& [A, B, C] = triangle;
    return {side(D, B, C), side(D, C, A), side(D, A, B)};
}

/// Whether the line passes inside (the paper's section 1.1.2): all three side products are ≥ 0 or all ≤ 0, and not all
/// are 0. Edges and vertices belong to the triangle. One that is seen edge-on, or without area, has three zeros.
template <class Real>
constexpr Truth<Real> inside(const Sides<Real>& sides) {
    const auto& [a, b, c] = sides;
    const Real zero(0);
    // & instead of &&: the signs of far triangles are random, and a branch for each would be mispredicted half the
    // time.
    const Truth<Real> left = (a >= zero) & (b >= zero) & (c >= zero);
    const Truth<Real> right = (a <= zero) & (b <= zero) & (c <= zero);
    return left != right;  // both hold where all three are 0
}

/// Where a ray from the origin along D crosses the triangle's plane: the hit point is the weighted mean of the
/// vertices, (aA + bB + cC) / (a + b + c) = tD, and its component along D is t.
template <class Real>
constexpr Real plane_t(const Vec3<Real>& D, const Triangle<Real>& triangle, const Sides<Real>& weights) {
    const auto& [A, B, C] = triangle;
    const auto& [a, b, c] = weights;
    const Real D2 = dot(D, D);
    return (a * (dot(D, A) / D2) + b * (dot(D, B) / D2) + c * (dot(D, C) / D2)) / (a + b + c);
}

}  // namespace glassbox
