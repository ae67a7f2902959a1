#pragma once
#include <cstddef>
#include <optional>

#include <not_written.hpp>
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

/// The nearer of the best hit so far and a crossing with another surface. At equal t the surface listed last wins.
template <class Real>
constexpr std::optional<Hit<Real>> nearest(const std::optional<Hit<Real>>& best, std::size_t surface,
                                           const Crossing<Real>& crossing) {
    return not_written<std::optional<Hit<Real>>>("nearest");
}

}  // namespace glassbox
