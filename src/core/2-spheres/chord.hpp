#pragma once
#include <ray.hpp>
#include <sphere.hpp>

namespace glassbox {

/// The chord that a sphere cuts out of a line P + tD, where they meet: its middle is the line's point nearest to the
/// centre, at t = m/a. From the centre v leads to the line's start P, and l to the chord's middle.
template <class Real>
struct Chord {
    Real a, m;
    Vec3<Real> v, l;
};

/// With v = P − C: a = D·D, m = −v·D, l = v + (m/a) D.
template <class Real>
constexpr Chord<Real> chord(const Ray<Real>& ray, const Sphere<Real>& sphere) {
    const Vec3<Real> D = ray.D;
    const Vec3<Real> v = ray.P - sphere.C;
    const Real a = dot(D, D);
    const Real m = -dot(v, D);
    return {a, m, v, v + (m / a) * D};
}

/// The same Δ as the quadratic equation's, from two lengths at the sphere: a (r² − l·l). After Haines et al.,
/// "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems (2019), chapter 7.
template <class Real>
constexpr Real discriminant(const Chord<Real>& chord, const Real& r) {
    const auto& [a, m, v, l] = chord;
    return a * (r * r - dot(l, l));
}

}  // namespace glassbox
