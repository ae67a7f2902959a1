#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <crossing.hpp>
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
    if (best && best->t == crossing.t && best->surface > surface) return best;
    return nearest(best, surface, crossing);
}

/// Whether a box that the ray enters at `enters` cannot hold anything nearer than the best hit. The hit's t and the
/// entry are rounded: only a box that is farther by more than the rounding is skipped.
template <class Real>
constexpr bool is_beyond(Real enters, const std::optional<Hit<Real>>& best) {
    return best && enters > widened<Real> * best->t;
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
    Stack<Real> stack;
    stack.push(waiting(0));
    while (!stack.is_empty()) {
        const Waiting<Real> next = stack.pop();
        if (is_empty(next.passage) || is_beyond(next.passage.enters, best)) continue;
        const Branch& branch = tree.branches[next.branch];
        if (branch.count > 0) {
            for (std::uint32_t i = branch.first; i < branch.first + branch.count; ++i)
                best = nearer(best, tree.surfaces[i], test(tree.surfaces[i]));
            continue;
        }
        const Waiting<Real> one = waiting(branch.first), other = waiting(branch.first + 1);
        const bool one_is_nearer = one.passage.enters <= other.passage.enters;
        stack.push(one_is_nearer ? other : one);  // the last one pushed is the first one popped
        stack.push(one_is_nearer ? one : other);
    }
    return best;
}

}  // namespace engine
}  // namespace glassbox
