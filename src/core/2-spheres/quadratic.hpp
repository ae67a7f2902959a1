#pragma once
#include <utility>

#include <ray.hpp>
#include <sphere.hpp>

namespace glassbox {

/// The equation a t² + 2b t + c = 0.
template <class Real>
struct Quadratic {
    Real a, b, c;
};

/// The equation for the t at which P + tD lies on the sphere. With v = P − C, |v + tD|² = r² is multiplied out to
/// a = D·D, b = v·D, c = v·v − r². It is the paper's (its section 1.1.1, for |D| = 1).
template <class Real>
constexpr Quadratic<Real> quadratic(const Ray<Real>& ray, const Sphere<Real>& sphere) {
    const Vec3<Real> D = ray.D;
    const Vec3<Real> v = ray.P - sphere.C;
    const Real r = sphere.r;
    return {dot(D, D), dot(v, D), dot(v, v) - r * r};
}

/// Δ = b² − ac, negative where there are no roots. For a sphere it is in units of length² |D|².
template <class Real>
constexpr Real discriminant(const Quadratic<Real>& equation) {
    const auto& [a, b, c] = equation;
    return b * b - a * c;
}

/// The two roots, the smaller first: (−b − √Δ) / a and (−b + √Δ) / a.
template <class Real>
constexpr std::pair<Real, Real> roots(const Quadratic<Real>& equation, const Real& root_of_discriminant) {
    const auto& [a, b, c] = equation;
    return {(-b - root_of_discriminant) / a, (-b + root_of_discriminant) / a};
}

}  // namespace glassbox
