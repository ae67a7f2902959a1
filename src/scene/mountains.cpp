#include "scene/mountains.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

// A line sweeps over the outline from left to right. The edges that it meets divide it into gaps, each with one winding
// number. The corners that an inside gap has reached are joined, in order, to a path. A path runs inside, because there
// is no other corner between two of its own; it divides the inside into monotone mountains (Fournier and Montuno 1984):
// each stands on an edge, or hangs from one, and its ridge is a piece of a path. A mountain is easily cut into
// triangles. Edges that lie on each other form one wall, with a mountain on either side.

namespace glassbox {
namespace {

/// An edge of the outline, by its corners from left to right.
struct Edge {
    std::size_t left, right;
    int rise;  ///< 1 if the outline goes to the right here, −1 if it goes back: the winding number above less that
               ///< below

    friend bool operator==(const Edge&, const Edge&) = default;
};

/// The part of the inside between a base and a path. The ridge's corners run from left to right, from the base's left
/// end on.
struct Mountain {
    Edge base;
    int winding;
    std::vector<std::size_t> ridge;
};

/// The edges on one line that meet the sweep line.
struct Wall {
    std::vector<Edge> edges;
    int winding_above;
    std::optional<Mountain> above, below;  ///< if that gap belongs to the inside
};

/// A wall's position, given by one of its edges that ends last.
struct Segment {
    Point2 left, right;
};

/// Orders walls, and points between them, from the lowest to the highest.
struct Below {
    using is_transparent = void;
    bool operator()(const Segment& a, const Point2& p) const { return orientation(a.left, a.right, p) > 0; }
    bool operator()(const Point2& p, const Segment& a) const { return orientation(a.left, a.right, p) < 0; }
    bool operator()(const Segment& a, const Segment& b) const {
        if (b.left < a.left) {
            const int side = orientation(b.left, b.right, a.left);
            return side != 0 ? side < 0 : orientation(b.left, b.right, a.right) < 0;
        }
        const int side = orientation(a.left, a.right, b.left);
        return side != 0 ? side > 0 : orientation(a.left, a.right, b.right) > 0;
    }
};

class Sweep {
public:
    explicit Sweep(std::span<const Point2> outline) : outline_(outline) {}

    /// Moves the sweep line to the place of `corner`, from which the `outgoing` edges run to the right. Returns false
    /// if it finds edges that cross.
    bool visit(std::size_t corner, std::vector<Edge> outgoing);

    std::vector<std::array<std::size_t, 3>> triangles;

private:
    using Walls = std::map<Segment, Wall, Below>;

    Segment segment(const Edge& edge) const { return {outline_[edge.left], outline_[edge.right]}; }
    std::vector<std::vector<Edge>> by_direction(const Point2& from, std::vector<Edge> edges) const;
    bool cross(const Segment& lower, const Segment& upper) const;
    void finish(Mountain mountain, std::size_t corner, bool stands);

    std::span<const Point2> outline_;
    Walls walls_;
};

/// Groups the edges through one point by direction, from the lowest to the highest.
std::vector<std::vector<Edge>> Sweep::by_direction(const Point2& from, std::vector<Edge> edges) const {
    const auto below = [&](const Edge& a, const Edge& b) {
        return orientation(from, outline_[a.right], outline_[b.right]) > 0;
    };
    std::stable_sort(edges.begin(), edges.end(), below);
    std::vector<std::vector<Edge>> groups;
    for (const Edge& edge : edges) {
        if (groups.empty() || below(groups.back().front(), edge)) groups.emplace_back();
        groups.back().push_back(edge);
    }
    return groups;
}

/// Whether two neighbours on the sweep line, now in this order, swap before one of them ends.
bool Sweep::cross(const Segment& lower, const Segment& upper) const {
    return lower.right < upper.right ? orientation(upper.left, upper.right, lower.right) > 0
                                     : orientation(lower.left, lower.right, upper.right) < 0;
}

/// Completes a mountain at its last corner: cuts off whatever juts out of the ridge, until the ridge lies on the base.
void Sweep::finish(Mountain mountain, std::size_t corner, bool stands) {
    mountain.ridge.push_back(corner);
    std::vector<std::size_t> left;
    for (const std::size_t c : mountain.ridge) {
        while (left.size() >= 2) {
            const std::size_t a = *(left.end() - 2), b = left.back();
            const int turn = orientation(outline_[a], outline_[b], outline_[c]);
            if (stands ? turn >= 0 : turn <= 0) break;
            if (stands == (mountain.winding > 0)) triangles.push_back({a, c, b});
            else triangles.push_back({a, b, c});
            left.pop_back();
        }
        left.push_back(c);
    }
}

bool Sweep::visit(std::size_t corner, std::vector<Edge> outgoing) {
    const Point2& p = outline_[corner];
    const auto [first, last] = walls_.equal_range(p);
    const auto under = first == walls_.begin() ? walls_.end() : std::prev(first), over = last;
    const int winding_under = under == walls_.end() ? 0 : under->second.winding_above;
    const int winding_over = first == last ? winding_under : std::prev(last)->second.winding_above;

    // Edges that end elsewhere continue through p.
    for (auto wall = first; wall != last; ++wall) {
        std::erase_if(wall->second.edges, [&](const Edge& edge) { return outline_[edge.right] == p; });
        outgoing.insert(outgoing.end(), wall->second.edges.begin(), wall->second.edges.end());
    }
    const std::vector<std::vector<Edge>> groups = by_direction(p, std::move(outgoing));

    // A gap whose base continues through p, with nothing between them, does not reach p.
    const auto passes = [&](const std::optional<Mountain>& mountain, const std::vector<Edge>& group) {
        return mountain && std::find(group.begin(), group.end(), mountain->base) != group.end();
    };
    std::optional<Mountain> passing_below, passing_above;
    if (first != last && !groups.empty()) {
        Wall &lowest = first->second, &highest = std::prev(last)->second;
        if (passes(lowest.below, groups.front())) passing_below = std::exchange(lowest.below, {});
        if (passes(highest.above, groups.back())) passing_above = std::exchange(highest.above, {});
    }
    if (winding_under != 0 && !passing_below) under->second.above->ridge.push_back(corner);
    if (winding_over != 0 && !passing_above) over->second.below->ridge.push_back(corner);

    for (auto wall = first; wall != last; ++wall) {
        if (wall->second.below) finish(*std::move(wall->second.below), corner, false);
        if (wall->second.above) finish(*std::move(wall->second.above), corner, true);
    }
    walls_.erase(first, last);

    int winding = winding_under;
    auto before = under;
    for (const std::vector<Edge>& group : groups) {
        // Among edges on each other, the base is one that has the inside on that side.
        const auto mountain = [&](int inside, int rise) -> std::optional<Mountain> {
            if (inside == 0) return {};
            const auto base =
                std::find_if(group.begin(), group.end(), [&](const Edge& edge) { return edge.rise == rise; });
            return Mountain{base == group.end() ? group.front() : *base, inside, {corner}};
        };
        const auto sign = [](int w) { return w < 0 ? -1 : 1; };
        Wall wall{group, winding, {}, mountain(winding, -sign(winding))};
        for (const Edge& edge : group) wall.winding_above += edge.rise;
        winding = wall.winding_above;
        wall.above = mountain(winding, sign(winding));
        if (&group == &groups.front() && passing_below) wall.below = std::move(passing_below);
        if (&group == &groups.back() && passing_above) wall.above = std::move(passing_above);

        const Edge& longest = *std::max_element(group.begin(), group.end(), [&](const Edge& a, const Edge& b) {
            return outline_[a.right] < outline_[b.right];
        });
        const auto inserted = walls_.emplace_hint(over, segment(longest), std::move(wall));
        if (before != walls_.end() && cross(before->first, inserted->first)) return false;
        before = inserted;
    }
    return before == walls_.end() || over == walls_.end() || !cross(before->first, over->first);
}

}  // namespace

std::optional<std::vector<std::array<std::size_t, 3>>> cut_into_mountains(std::span<const Point2> outline) {
    std::vector<std::size_t> corners(outline.size());
    std::iota(corners.begin(), corners.end(), std::size_t{0});
    std::stable_sort(corners.begin(), corners.end(),
                     [&](std::size_t a, std::size_t b) { return outline[a] < outline[b]; });

    Sweep sweep(outline);
    for (auto begin = corners.begin(); begin != corners.end();) {
        const Point2& place = outline[*begin];
        const auto end = std::find_if(begin, corners.end(), [&](std::size_t c) { return outline[c] != place; });
        std::vector<Edge> outgoing;
        for (auto at = begin; at != end; ++at) {
            const std::size_t before = (*at + outline.size() - 1) % outline.size(), after = (*at + 1) % outline.size();
            if (place < outline[after]) outgoing.push_back({*at, after, 1});
            if (place < outline[before]) outgoing.push_back({*at, before, -1});
        }
        if (!sweep.visit(*begin, std::move(outgoing))) return {};
        begin = end;
    }
    return std::move(sweep.triangles);
}

}  // namespace glassbox
