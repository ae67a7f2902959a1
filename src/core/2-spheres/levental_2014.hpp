#pragma once
#include <intersect_sphere.hpp>

namespace glassbox {

/// The roots that a rule finds, for another rule to go on with.
template <class Rule, class Real, class Probe>
constexpr Roots<Real> roots_by(const Rule& rule, const Ray<Real>& ray, const Sphere<Real>& sphere, Probe& probe) {
    return rule(ray, sphere, probe);
}

/// The rule of the paper's program, kept as history, like Tolerance: the paper's five figures need both of its faults.
/// It computes Textbook's roots but requires Δ > 0, two different roots: a tangent ray misses the sphere. It returns
/// the nearer root for both: seen from inside, where that root lies behind the ray's start, the sphere vanishes.
struct Levental2014 {
    constexpr bool operator==(const Levental2014&) const = default;

    template <class Real, class Probe>
    constexpr Roots<Real> operator()(const Ray<Real>& ray, const Sphere<Real>& sphere, Probe& probe) const {
        const auto [real, t0, t1] = roots_by(Textbook{}, ray, sphere, probe);
        // t₀ < t₁ means Δ > 0, even when rounded: b² − ac is 0 or at least about an ulp of b², and its root, half as
        // many digits down, is not lost when it is added to b.
        return {real && t0 < t1, t0, t0};
    }
};

}  // namespace glassbox
