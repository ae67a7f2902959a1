#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <box.hpp>

namespace glassbox::engine {

// A hierarchy of boxes as lesson 7 has it: two halves to a branch, one thread, no vectors. What renders is its quick
// cousin, Hierarchy, with eight children to a node. They are held against each other by a test.

/// A box, and what lies in it: surfaces, or two branches that together hold the same.
struct Branch {
    Box box;
    std::uint32_t first = 0;  ///< of its surfaces, in Tree::surfaces; or its first half, and the other one follows
    std::uint32_t count = 0;  ///< of surfaces; 0 where there are two halves instead
};

/// Branch 0 holds all. There is none where there are no surfaces.
struct Tree {
    std::vector<Branch> branches;
    std::vector<std::uint32_t> surfaces;  ///< leaf by leaf
};

/// No branch has more above it.
inline constexpr int most_levels_of_a_tree = 64;

/// How many boxes go to the left, and what it costs: the expected number of tests, times half the area of the box
/// around all.
struct Cut {
    std::size_t left = 0;
    float cost = std::numeric_limits<float>::infinity();
};

/// Where to cut boxes that stand in order along an axis, two or more, so that the surface area heuristic is least: half
/// the area of the box around the left ones, times their number, plus the same of the right ones. Of equal cuts the
/// first. (MacDonald and Booth, "Heuristics for Ray Tracing Using Space Subdivision", 1990.)
inline Cut best_cut(std::span<const Box> boxes) {
    std::vector<float> right_cost(boxes.size());
    Box right;
    for (std::size_t i = boxes.size() - 1; i > 0; --i) {
        right.add(boxes[i]);
        right_cost[i] = right.half_area() * static_cast<float>(boxes.size() - i);
    }
    Cut best;
    Box left;
    for (std::size_t i = 1; i < boxes.size(); ++i) {
        left.add(boxes[i - 1]);
        const float cost = left.half_area() * static_cast<float>(i) + right_cost[i];
        if (cost < best.cost) best = {i, cost};
    }
    return best;
}

namespace growing {

/// Surfaces in the order of their boxes' middles along an axis.
inline void sort(std::span<std::uint32_t> surfaces, std::span<const Box> box_of, int axis) {
    std::ranges::sort(surfaces, {}, [&](std::uint32_t s) { return std::pair(box_of[s].middle2(axis), s); });
}

/// Makes a branch of surfaces [first, first + count) of the tree, and all below it. `few` have no more than four.
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
    // To test two boxes takes about as long as to test one surface: that must be worth it.
    const float as_leaf = all.box.half_area() * static_cast<float>(count);
    if (count <= 4 && !(best.cost + all.box.half_area() < as_leaf)) return;
    sort(surfaces, box_of, best_axis);
    // Where no cut is good, or so deep down that none has helped, in the middle.
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

/// The tree over the surfaces 0, 1, 2, … that lie in these boxes; at most 2³² of them.
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
