#pragma once
#include <cmath>

#include <chord.hpp>
#include <crossing.hpp>
#include <quadratic.hpp>

namespace glassbox {

namespace told {
struct Discriminant {};  ///< (v·D)² − D²(v² − r²), in units of length² |D|²: negative where the ray's line misses
struct Roots {};         ///< (t₀, t₁), t₀ ≤ t₁: where the ray's line enters and leaves the sphere
}  // namespace told

/// Where a line enters and leaves a sphere: t₀ ≤ t₁, if the line meets it.
template <class Real>
struct Roots {
    Truth<Real> real{false};
    Real t0{}, t1{};
};

/// The roots by the textbook's formula. It loses a sphere that is small and far away: v² and r² differ too much in
/// size.
struct Textbook {
    constexpr bool operator==(const Textbook&) const = default;

    template <class Real, class Probe>
    constexpr Roots<Real> operator()(const Ray<Real>& ray, const Sphere<Real>& sphere, Probe& probe) const {
        using std::sqrt;
        const Quadratic<Real> equation = quadratic(ray, sphere);
        const Real delta = discriminant(equation);
        probe(told::Discriminant{}, delta);
        const Truth<Real> real = delta >= Real(0);
        if (!possibly(real)) return {};
        const auto [t0, t1] = roots(equation, sqrt(delta));
        return {real, t0, t1};
    }
};

/// The same roots without the cancellation, after Haines et al. (2019): r² − l² compares two lengths at the sphere,
/// wherever the ray starts; and q adds two numbers of the same sign. One root is q/a, and c/a is the product of both.
struct Stable {
    constexpr bool operator==(const Stable&) const = default;

    template <class Real, class Probe>
    constexpr Roots<Real> operator()(const Ray<Real>& ray, const Sphere<Real>& sphere, Probe& probe) const {
        using std::sqrt;
        const Real r = sphere.r;
        const Chord<Real> cut = chord(ray, sphere);
        const Real delta = discriminant(cut, r);
        probe(told::Discriminant{}, delta);
        const Truth<Real> real = delta >= Real(0);
        if (!possibly(real)) return {};
        const auto& [a, m, v, l] = cut;
        const Real c = dot(v, v) - r * r;
        const Real root = sqrt(delta);
        const Real q = surely(m < Real(0)) ? m - root : m + root;
        if (!possibly(q != Real(0))) return {real, Real(0), Real(0)};
        return surely(m < Real(0)) ? Roots<Real>{real, q / a, c / q} : Roots<Real>{real, c / q, q / a};
    }
};

/// Where the ray first meets the sphere. A tangent ray meets it. `rule` is Textbook or Stable, which find the roots.
template <class Real, class RootsRule, class Probe>
constexpr Crossing<Real> intersect(const Ray<Real>& ray, const Sphere<Real>& sphere, const RootsRule& rule,
                                   Probe& probe) {
    probe(told::Tested{});
    const auto [real, t0, t1] = rule(ray, sphere, probe);
    if (!possibly(real)) return {};
    probe(told::Roots{}, t0, t1);
    const Real t = first_ahead(t0, t1);
    return {real && t > Real(0), t};
}

}  // namespace glassbox
