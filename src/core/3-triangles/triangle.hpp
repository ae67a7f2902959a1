#pragma once
#include <vec3.hpp>

namespace glassbox {

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
    const auto& [A, B, C] = triangle;
    return unit(cross(B - A, C - A));
}

}  // namespace glassbox
