#pragma once
#include <cmath>
#include <utility>

#include <crossing.hpp>
#include <not_written.hpp>
#include <ray.hpp>

namespace glassbox {

namespace told {
struct Discriminant {};  ///< (v·D)² − D²(v² − r²), in units of length² |D|²: negative where the ray's line misses
struct Roots {};         ///< (t₀, t₁), t₀ ≤ t₁: where the ray's line enters and leaves the sphere
}  // namespace told

/// All points at distance r > 0 from the centre c.
template <class Real>
struct Sphere {
    Vec3<Real> c;
    Real r;
};

/// The same sphere in another scalar.
template <class To, class From>
constexpr Sphere<To> convert(const Sphere<From>& sphere) {
    return {convert<To>(sphere.c), static_cast<To>(sphere.r)};
}

/// Where a line enters and leaves a sphere: t₀ ≤ t₁, if the line meets it.
template <class Real>
struct Roots {
    Truth<Real> real{false};
    Real t0{}, t1{};
};

/// The roots by the textbook formula, t = (−v·D ± √((v·D)² − D²(v² − r²))) / D² with v = P − c. It is the paper's
/// formula (its section 1.1.1, for |D| = 1). It loses a sphere that is small and far away: v² and r² differ too much in
/// size.
struct Textbook {
    constexpr bool operator==(const Textbook&) const = default;

    template <class Real, class Probe>
    constexpr Roots<Real> operator()(const Ray<Real>& ray, const Sphere<Real>& sphere, Probe& probe) const {
        using std::sqrt;
        return not_written<Roots<Real>>("Textbook");
    }
};

/// The same roots without the cancellation, after Haines et al., "Precision Improvements for Ray/Sphere Intersection",
/// Ray Tracing Gems (2019), chapter 7: l is the vector from the centre to the line, so r² − l² compares two lengths at
/// the sphere, wherever the ray starts; and q adds two numbers of the same sign.
struct Stable {
    constexpr bool operator==(const Stable&) const = default;

    template <class Real, class Probe>
    constexpr Roots<Real> operator()(const Ray<Real>& ray, const Sphere<Real>& sphere, Probe& probe) const {
        using std::sqrt;
        return not_written<Roots<Real>>("Stable");
    }
};

/// Where the ray first meets the sphere: at the smaller root, or at the larger if the smaller lies behind the ray's
/// start, as it does from inside. A tangent ray meets the sphere. `roots` is Textbook or Stable.
template <class Real, class RootsRule, class Probe>
constexpr Crossing<Real> intersect(const Ray<Real>& ray, const Sphere<Real>& sphere, const RootsRule& roots,
                                   Probe& probe) {
    probe(told::Tested{});
    return not_written<Crossing<Real>>("intersect");
}

/// The outward unit normal at a point of the sphere: (point − c) / |point − c|.
template <class Real>
Vec3<Real> normal(const Sphere<Real>& sphere, const Vec3<Real>& point) {
    return not_written<Vec3<Real>>("normal");
}

}  // namespace glassbox
