#pragma once
#include <cmath>
#include <utility>

#include <crossing.hpp>
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
        const Vec3<Real> D = ray.D;
        const Vec3<Real> v = ray.P - sphere.c;
        const Real a = dot(D, D);
        const Real b = dot(v, D);
        const Real c = dot(v, v) - sphere.r * sphere.r;
        const Real discriminant = b * b - a * c;
        probe(told::Discriminant{}, discriminant);
        const Truth<Real> real = discriminant >= Real(0);
        if (!possibly(real)) return {};
        const Real root = sqrt(discriminant);
        return {real, (-b - root) / a, (-b + root) / a};
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
        const Vec3<Real> d = ray.D;
        const Vec3<Real> f = ray.P - sphere.c;
        const Real r = sphere.r;
        const Real a = dot(d, d);
        const Real b = -dot(f, d);
        const Vec3<Real> l = f + (b / a) * d;
        const Real discriminant = a * (r * r - dot(l, l));
        probe(told::Discriminant{}, discriminant);
        const Truth<Real> real = discriminant >= Real(0);
        if (!possibly(real)) return {};
        const Real c = dot(f, f) - r * r;
        const Real root = sqrt(discriminant);
        const Real q = surely(b < Real(0)) ? b - root : b + root;
        if (!possibly(q != Real(0))) return {real, Real(0), Real(0)};
        return surely(b < Real(0)) ? Roots<Real>{real, q / a, c / q} : Roots<Real>{real, c / q, q / a};
    }
};

/// Where the ray first meets the sphere: at the smaller root, or at the larger if the smaller lies behind the ray's
/// start, as it does from inside. A tangent ray meets the sphere. `roots` is Textbook or Stable.
template <class Real, class RootsRule, class Probe>
constexpr Crossing<Real> intersect(const Ray<Real>& ray, const Sphere<Real>& sphere, const RootsRule& roots,
                                   Probe& probe) {
    probe(told::Tested{});
    const auto [real, t0, t1] = roots(ray, sphere, probe);
    if (!possibly(real)) return {};
    probe(told::Roots{}, t0, t1);
    if (possibly(t0 > Real(0))) return {real && t0 > Real(0), t0};
    return {real && t1 > Real(0), t1};
}

/// The outward unit normal at a point of the sphere: (point − c) / |point − c|.
template <class Real>
Vec3<Real> normal(const Sphere<Real>& sphere, const Vec3<Real>& point) {
    return unit(point - sphere.c);
}

}  // namespace glassbox
