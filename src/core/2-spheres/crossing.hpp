#pragma once
#include <cstddef>
#include <optional>

#include <truth.hpp>

namespace glassbox {

namespace told {
struct Tested {};  ///< one surface is tested against the ray
struct Met {};     ///< (surface, t): the ray meets it, ahead of its start
}  // namespace told

/// The result of testing a ray against a surface: whether the ray meets it ahead of its start, and at which t > 0.
template <class Real>
struct Crossing {
    Truth<Real> met{false};
    Real t{};
};

/// The surface that a ray meets first: its index, and t in units of |D|.
template <class Real>
struct Hit {
    std::size_t surface;
    Real t;
};

/// Which of the two places where a line enters and leaves a surface the ray sees, t₀ ≤ t₁: the first if it lies ahead,
/// t₀ > 0, else the second. It is for the caller to see whether that one lies ahead.
template <class Real>
constexpr Real first_ahead(const Real& t0, const Real& t1) {
    return choose(t0 > Real(0), t0, t1);
}

/// The nearer of the best hit so far and a crossing with another surface. At equal t the surface listed last wins.
template <class Real>
constexpr std::optional<Hit<Real>> nearest(const std::optional<Hit<Real>>& best, std::size_t surface,
                                           const Crossing<Real>& crossing) {
    if (!crossing.met || (best && best->t < crossing.t)) return best;
    return Hit<Real>{surface, crossing.t};
}

}  // namespace glassbox
