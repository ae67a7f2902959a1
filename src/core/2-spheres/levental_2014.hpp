#pragma once
#include <sphere.hpp>

namespace glassbox {

/// History, kept as Tolerance is: the paper's program, whose five figures need both of its faults. Its roots are the
/// textbook's, but it asks for Δ > 0, for two that differ: a ray that only touches the sphere misses it. And it looks
/// at the nearer root alone, which stands for both here: from inside, where that lies behind, the sphere vanishes.
struct Levental2014 {
    constexpr bool operator==(const Levental2014&) const = default;

    template <class Real, class Probe>
    constexpr Roots<Real> operator()(const Ray<Real>& ray, const Sphere<Real>& sphere, Probe& probe) const {
        const auto [real, t0, t1] = Textbook{}(ray, sphere, probe);
        // t₀ < t₁ is Δ > 0, also where it is rounded: b² − ac is 0 or at least about an ulp of b², and its root, half
        // as many digits down, is not lost beside b.
        return {real && t0 < t1, t0, t0};
    }
};

}  // namespace glassbox
