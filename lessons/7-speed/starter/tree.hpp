#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <not_written.hpp>
#include <span>
#include <utility>
#include <vector>

#include <box.hpp>

namespace glassbox::engine {

// The bounding volume hierarchy of lesson 7: two halves per branch, one thread, no vector instructions. The renderer
// uses the faster Hierarchy, with eight children per node. A test compares the two.

/// A box, and its content: surfaces, or two branches that together hold them.
struct Branch {
    Box box;
    std::uint32_t first = 0;  ///< its first surface, in Tree::surfaces; or its first half, which the other half follows
    std::uint32_t count = 0;  ///< number of its surfaces; 0 if it has two halves instead
};

/// Branch 0 is the root. A tree without surfaces has no branches.
struct Tree {
    std::vector<Branch> branches;
    std::vector<std::uint32_t> surfaces;  ///< in the order of the leaves
};

/// No branch has more branches above it.
inline constexpr int most_levels_of_a_tree = 64;

/// How many boxes go to the left, and the cost: the expected number of tests, times half the area of the box around
/// all.
struct Cut {
    std::size_t left = 0;
    float cost = std::numeric_limits<float>::infinity();
};

/// Where to cut two or more boxes, in order along an axis, to minimize the surface area heuristic: half the area of the
/// box around the left ones times their number, plus the same of the right ones. Returns the first of equal cuts.
/// (MacDonald and Booth, "Heuristics for Ray Tracing Using Space Subdivision", 1990.)
inline Cut best_cut(std::span<const Box> boxes) {
    // Your turn: first the costs of all right parts, from the right; then try each cut, from the left
    return not_written<Cut>("best_cut");
}

namespace growing {

/// Sorts surfaces by the centres of their boxes along an axis.
inline void sort(std::span<std::uint32_t> surfaces, std::span<const Box> box_of, int axis) {
    std::ranges::sort(surfaces, {}, [&](std::uint32_t s) { return std::pair(box_of[s].middle2(axis), s); });
}

/// Builds the branch of the tree's surfaces [first, first + count), and all branches below it.
inline void grow(Tree& tree, std::span<const Box> box_of, std::size_t branch, std::size_t first, std::size_t count,
                 int level) {
    const auto surfaces = std::span(tree.surfaces).subspan(first, count);
    Branch all{{}, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)};
    for (const std::uint32_t s : surfaces) all.box.add(box_of[s]);
    tree.branches[branch] = all;
    if (count < 2) return;

    Cut best;
    int best_axis = 0;
    std::vector<Box> in_order(count);
    for (int axis = 0; axis < 3; ++axis) {
        sort(surfaces, box_of, axis);
        std::ranges::transform(surfaces, in_order.begin(), [&](std::uint32_t s) { return box_of[s]; });
        const Cut cut = best_cut(in_order);
        if (!(cut.cost < best.cost)) continue;
        best = cut;
        best_axis = axis;
    }
    // Testing two boxes takes about as long as testing one surface: a cut must save more than that.
    const float as_leaf = all.box.half_area() * static_cast<float>(count);
    if (count <= 4 && !(best.cost + all.box.half_area() < as_leaf)) return;
    sort(surfaces, box_of, best_axis);
    // Cuts in the middle where no cut is good, or so deep down that none has helped.
    const bool is_cut = best.left > 0 && best.left < count && level < most_levels_of_a_tree / 2;
    const std::size_t left = is_cut ? best.left : count / 2;

    const std::size_t halves = tree.branches.size();
    tree.branches.resize(halves + 2);
    tree.branches[branch].first = static_cast<std::uint32_t>(halves);
    tree.branches[branch].count = 0;
    grow(tree, box_of, halves, first, left, level + 1);
    grow(tree, box_of, halves + 1, first + left, count - left, level + 1);
}

}  // namespace growing

/// Builds the tree over the surfaces 0, 1, 2, … with these boxes; at most 2³² of them.
inline Tree tree_over(std::span<const Box> boxes) {
    Tree tree;
    if (boxes.empty()) return tree;
    tree.surfaces.resize(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) tree.surfaces[i] = static_cast<std::uint32_t>(i);
    tree.branches.resize(1);
    growing::grow(tree, boxes, 0, 0, boxes.size(), 0);
    return tree;
}

}  // namespace glassbox::engine
