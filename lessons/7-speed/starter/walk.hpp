#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <crossing.hpp>
#include <not_written.hpp>
#include <ray.hpp>

#include <slabs.hpp>
#include <tree.hpp>

namespace glassbox {

namespace told {
struct BoxTested {};  ///< a ray is tested against one box
}  // namespace told

namespace engine {

/// Lesson 2's `nearest`, for surfaces tested in any order: at equal t the surface with the larger number wins,
/// whichever was tested first.
template <class Real>
constexpr std::optional<Hit<Real>> nearer(const std::optional<Hit<Real>>& best, std::size_t surface,
                                          const Crossing<Real>& crossing) {
    // Your turn: `nearest`, but for two hits at equal t
    return not_written<std::optional<Hit<Real>>>("nearer");
}

/// Whether a box that the ray enters at `enters` cannot hold anything nearer than the best hit. The hit's t and the
/// entry are rounded: only a box that is farther by more than the rounding is skipped.
template <class Real>
constexpr bool is_beyond(Real enters, const std::optional<Hit<Real>>& best) {
    // Your turn: is there a hit, and does the box begin farther off, by more than rounding?
    return not_written<bool>("is_beyond");
}

/// A branch to be visited later, and the t at which the ray is in its box.
template <class Real>
struct Waiting {
    std::uint32_t branch;
    Interval<Real> passage;
};

/// The branches to be visited: the last one pushed is the first one popped.
template <class Real>
class Stack {
public:
    bool is_empty() const { return size_ == 0; }
    void push(const Waiting<Real>& one) { waiting_.at(size_++) = one; }
    Waiting<Real> pop() { return waiting_.at(--size_); }

private:
    std::array<Waiting<Real>, most_levels_of_a_tree + 2> waiting_;
    std::size_t size_ = 0;
};

/// Finds the surface that the ray meets first. `test(surface)` gives the crossing with a surface. Visits the nearer
/// half of a branch first, and skips every branch that begins beyond the best hit so far.
template <class Real, class Test, class Probe>
std::optional<Hit<Real>> walk(const Tree& tree, const Ray<Real>& ray, const Test& test, Probe& probe) {
    std::optional<Hit<Real>> best;
    if (tree.branches.empty()) return best;
    const Vec3<Real> inverse_D = inverse(ray.D);
    const auto waiting = [&](std::uint32_t branch) {
        probe(told::BoxTested{});
        return Waiting<Real>{branch, through(tree.branches[branch].box, ray.P, inverse_D)};
    };
    // Your turn: a stack of what waits, with the whole tree to begin with; then one after the other, until none waits
    return not_written<std::optional<Hit<Real>>>("walk");
}

}  // namespace engine
}  // namespace glassbox
