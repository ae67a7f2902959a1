// Outlines that touch themselves, made of cells of a grid, so that what they go around is known. Everything is in
// integers, and nothing is rounded: neither here, nor, if it is right, in the code under test.
#include <doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <utility>

#include "scene/polygon.hpp"

using namespace glassbox;

namespace {

struct Place {
    std::int64_t x, y;
    friend auto operator<=>(const Place&, const Place&) = default;
};
using Outline = std::vector<Place>;
using Triangles = std::vector<std::array<std::size_t, 3>>;

Place operator-(const Place& a, const Place& b) { return {a.x - b.x, a.y - b.y}; }

std::int64_t twice_area(const Place& a, const Place& b, const Place& c) {
    const Place ab = b - a, ac = c - a;
    return ab.x * ac.y - ab.y * ac.x;
}

std::int64_t twice_area(const Outline& outline) {
    std::int64_t sum = 0;
    for (std::size_t k = 1; k + 1 < outline.size(); ++k) sum += twice_area(outline[0], outline[k], outline[k + 1]);
    return sum;
}

/// Whether p is a point of the segment, but not one of its ends.
bool lies_within(const Place& p, const Place& a, const Place& b) {
    return p != a && p != b && twice_area(a, b, p) == 0 && std::min(a, b) < p && p < std::max(a, b);
}

/// How often each edge is walked from place to place, minus how often back.
using Ways = std::map<std::pair<Place, Place>, int>;

void go(Ways& ways, const Place& a, const Place& b) {
    if (a == b) return;
    const auto way = ways.try_emplace(std::minmax(a, b), 0).first;
    way->second += a < b ? 1 : -1;
    if (way->second == 0) ways.erase(way);
}

/// The same, step by step: from each of the stops on the way to the next.
void go_by(Ways& ways, const std::set<Place>& stops, const Place& a, const Place& b) {
    Outline way{a, b};
    for (const Place& stop : stops)
        if (lies_within(stop, a, b)) way.push_back(stop);
    std::sort(way.begin(), way.end());
    if (b < a) std::reverse(way.begin(), way.end());
    for (std::size_t k = 0; k + 1 < way.size(); ++k) go(ways, way[k], way[k + 1]);
}

template <class Go>
void go_around(const Outline& corners, const Go& go) {
    for (std::size_t k = 0; k < corners.size(); ++k) go(corners[k], corners[(k + 1) % corners.size()]);
}

/// Whether the triangles are what the outline goes around, each point once: all have its orientation, none is flat, and
/// their edges, each cut where a corner lies on it, cancel each other out but for the outline's own. Then the sum of
/// the triangles' winding numbers is the outline's at every point. If no corner touches an edge, the edges cancel out
/// as they are: there is no crack beside another polygon.
bool fills(const Triangles& triangles, const Outline& outline) {
    const std::set<Place> stops(outline.begin(), outline.end());
    const bool runs_left = twice_area(outline) > 0;
    Ways stepwise, whole;
    bool is_touched = false;
    go_around(outline, [&](const Place& a, const Place& b) {
        go_by(stepwise, stops, b, a);
        go(whole, b, a);
        is_touched |= std::any_of(stops.begin(), stops.end(), [&](const Place& p) { return lies_within(p, a, b); });
    });
    std::int64_t sum = 0;
    for (const auto& [a, b, c] : triangles) {
        const Outline corners{outline[a], outline[b], outline[c]};
        const std::int64_t area = twice_area(corners);
        if (area == 0 || (area > 0) != runs_left) return false;
        sum += area;
        go_around(corners, [&](const Place& from, const Place& to) {
            go_by(stepwise, stops, from, to);
            go(whole, from, to);
        });
    }
    return sum == twice_area(outline) && stepwise.empty() && (is_touched || whole.empty());
}

/// The outline in a plane of space. Coordinates up to 2²⁹ and these factors are exact in double.
std::vector<Vec3<double>> in_space(const Outline& outline, int plane) {
    std::vector<Vec3<double>> polygon;
    for (const Place& p : outline) {
        const auto x = static_cast<double>(p.x), y = static_cast<double>(p.y);
        if (plane == 0) polygon.push_back({x, y, 7});
        else if (plane == 1) polygon.push_back({0x1p-1050 * x, -5, 0x1p-1050 * y});
        else if (plane == 2) polygon.push_back({0x1p900 * (3 * x - 5 * y), 0x1p900 * x, 0x1p900 * y});
        else polygon.push_back({x, 2 * x - 9 * y, y});
    }
    return polygon;
}
constexpr int planes = 4;

/// Checks the outline from each corner, both ways round.
void check_all_ways(Outline outline, int plane) {
    for (std::size_t way = 0; way < 2 * outline.size(); ++way) {
        const Triangles triangles = triangulate(in_space(outline, plane));
        INFO("plane ", plane, ", way ", way);
        REQUIRE(fills(triangles, outline));
        std::rotate(outline.begin(), outline.begin() + 1, outline.end());
        if (way + 1 == outline.size()) std::reverse(outline.begin(), outline.end());
    }
}

using Random = std::mt19937;

std::size_t below(Random& random, std::size_t n) { return random() % n; }

/// A cell of the grid: half of a unit square, counter-clockwise.
using Cell = std::array<Place, 3>;

/// The six cells around a place, each from that place on.
std::array<Cell, 6> cells_around(const Place& p) {
    const auto at = [&](std::int64_t dx, std::int64_t dy) { return Place{p.x + dx, p.y + dy}; };
    const std::array<Place, 6> ring{at(1, 0), at(1, 1), at(0, 1), at(-1, 0), at(-1, -1), at(0, -1)};
    std::array<Cell, 6> cells;
    for (std::size_t k = 0; k < 6; ++k) cells[k] = {p, ring[k], ring[(k + 1) % 6]};
    return cells;
}

/// The same cell, whatever place it is seen from.
Cell by_least_corner(Cell cell) {
    std::rotate(cell.begin(), std::min_element(cell.begin(), cell.end()), cell.end());
    return cell;
}

struct Patch {
    Outline outline;
    std::set<Cell> cells;  ///< what the outline goes around, counter-clockwise
};

/// Grows from a cell: at some corner the outline is led around another one, too, or along an edge and back. Then some
/// walks straight there and back are left out, and some corners where it goes straight on: cells grow together, rows of
/// corners become edges, and others come to touch them. Two edges never go on through the same place.
Patch random_patch(Random& random, std::size_t growth) {
    const Cell first = cells_around({0, 0})[0];
    Patch patch{{first.begin(), first.end()}, {by_least_corner(first)}};
    Outline& outline = patch.outline;
    for (std::size_t k = 0; k < growth; ++k) {
        const std::size_t at = below(random, outline.size());
        const auto [p, x, y] = cells_around(outline[at])[below(random, 6)];
        const auto here = outline.begin() + static_cast<std::ptrdiff_t>(at);
        if (below(random, 8) == 0) outline.insert(here, {p, x});
        else if (patch.cells.insert(by_least_corner({p, x, y})).second) outline.insert(here, {p, x, y});
    }
    const std::size_t one_in = 1 + below(random, 4);  // may go
    for (std::size_t k = 0; k < 20 * outline.size() && outline.size() > 4; ++k) {
        const std::size_t n = outline.size(), at = below(random, n);
        const Place &a = outline[at], &b = outline[(at + 1) % n], &c = outline[(at + 2) % n];
        bool is_free = true;
        for (std::size_t i = 0; i < n; ++i) is_free &= !lies_within(b, outline[i], outline[(i + 1) % n]);
        const bool can_go = a == b || a == c || (is_free && lies_within(b, a, c));
        if (can_go && below(random, one_in) == 0)
            outline.erase(outline.begin() + static_cast<std::ptrdiff_t>((at + 1) % n));
    }
    return patch;
}

/// Turned and pulled: (x, y) → (ax + by, cx + dy), ad − bc = ±1, so that each cell's area stays 1/2.
Outline mapped(Outline outline, std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    for (auto& [x, y] : outline) std::tie(x, y) = std::tuple(a * x + b * y, c * x + d * y);
    return outline;
}

/// A band of width 1 that winds inwards along squares, 2 from round to round: first its outer side, then its inner side
/// back. It has 8 corners a round.
Outline spiral(std::int64_t rounds) {
    Outline outer, inner;
    for (std::int64_t k = 0; k < rounds; ++k) {
        const std::int64_t low = 2 * k, high = 4 * rounds - low, from = std::max(low - 2, std::int64_t{0});
        outer.insert(outer.end(), {{from, low}, {high, low}, {high, high}, {low, high}});
        inner.insert(
            inner.end(),
            {{k == 0 ? 0 : from + 1, low + 1}, {high - 1, low + 1}, {high - 1, high - 1}, {low + 1, high - 1}});
    }
    outer.insert(outer.end(), inner.rbegin(), inner.rend());
    return outer;
}

/// A bar with teeth, each one unit wide and one unit apart, pointed or not, and corners along its back.
Outline comb(std::int64_t teeth, bool is_sharp) {
    Outline outline;
    for (std::int64_t x = 0; x <= 2 * teeth; ++x) outline.push_back({x, 0});
    for (std::int64_t x = 2 * teeth; x > 0; x -= 2) {
        outline.insert(outline.end(), {{x, 9}});
        if (!is_sharp) outline.insert(outline.end(), {{x - 1, 9}});
        outline.insert(outline.end(), {{x - 1, 1}, {x - 2, 1}});
    }
    return outline;
}

/// Fibonacci's numbers 38 to 40: neighbours' determinant is ±1. Products of such coordinates do not fit in a double.
constexpr std::int64_t F38 = 39088169, F39 = 63245986, F40 = 102334155;

}  // namespace

TEST_CASE("Two lobes that share a corner are filled, wherever the outline begins") {
    // Below (5,5) a triangle as wide as 9 and as high as 5, above it one as high as 4.
    const Outline lobes{{0, 0}, {9, 0}, {5, 5}, {9, 9}, {0, 9}, {5, 5}};
    CHECK(twice_area(lobes) == 9 * 5 + 9 * 4);
    for (int plane = 0; plane < planes; ++plane) check_all_ways(lobes, plane);
    CHECK(triangulate(in_space(lobes, 0)) == Triangles{{0, 1, 2}, {2, 3, 4}});
}

TEST_CASE("An outline that touches its own edge, from inside and from outside, is filled") {
    // A square whose lower edge is touched by the tip of a notch; and one with an ear that bends back to its upper
    // edge.
    const Outline notch{{0, 0}, {8, 0}, {8, 8}, {5, 8}, {4, 0}, {3, 8}, {0, 8}};
    const Outline ear{{0, 0}, {8, 0}, {8, 12}, {4, 8}, {7, 9}, {7, 8}, {0, 8}};
    CHECK(twice_area(notch) == 2 * (64 - 8));
    for (int plane = 0; plane < planes; ++plane) {
        check_all_ways(notch, plane);
        check_all_ways(ear, plane);
    }
}

TEST_CASE("Two places joined by an edge that is walked there and back, in one step and in two") {
    const Outline dumbbell{{0, 0}, {2, 0}, {9, 0}, {11, -2}, {11, 2}, {9, 0}, {5, 0}, {2, 0}, {0, 2}};
    CHECK(twice_area(dumbbell) == 4 + 8);
    for (int plane = 0; plane < planes; ++plane) check_all_ways(dumbbell, plane);
}

TEST_CASE("Combs and small spirals, with corners along their edges") {
    for (int plane = 0; plane < planes; ++plane) {
        for (const Outline& outline : {comb(7, true), comb(7, false), spiral(1), spiral(2), spiral(5)}) {
            check_all_ways(outline, plane);
            check_all_ways(mapped(outline, 1, 1, 1, 2), plane);
            CHECK(triangulate(in_space(outline, plane)).size() == outline.size() - 2);
        }
    }
}

TEST_CASE("What an outline goes around is filled, however it touches itself") {
    Random random(2014);
    for (int round = 0; round < 150; ++round) {
        const Patch patch = random_patch(random, 3 + below(random, 20));
        REQUIRE(twice_area(patch.outline) == static_cast<std::int64_t>(patch.cells.size()));
        const int plane = round % planes;
        INFO("round ", round);
        check_all_ways(patch.outline, plane);
        check_all_ways(mapped(patch.outline, 1, 2, -1, -1), plane);
        if (plane == 0 || plane == 3) check_all_ways(mapped(patch.outline, F38, F39, F39, F40), plane);
    }
}

TEST_CASE("Of random points, those in the outline's cells lie in one triangle each, the others in none") {
    Random random(1);
    for (int round = 0; round < 200; ++round) {
        const Patch patch = random_patch(random, 5 + below(random, 60));
        const Triangles triangles = triangulate(in_space(patch.outline, 0));
        for (int k = 0; k < 50; ++k) {
            // Within a cell near the outline, in sixteenths: on no triangle's edge but by chance.
            const std::array<Cell, 6> cells = cells_around(patch.outline[below(random, patch.outline.size())]);
            const Cell cell = cells[below(random, 6)];
            const auto s = static_cast<std::int64_t>(1 + below(random, 7)),
                       t = static_cast<std::int64_t>(1 + below(random, 7));
            const auto [p, a, b] = cell;
            const Place point{16 * p.x + s * (a - p).x + t * (b - p).x, 16 * p.y + s * (a - p).y + t * (b - p).y};
            int inside = 0, on_edge = 0;
            for (const auto& abc : triangles) {
                std::array<std::int64_t, 3> sides{};
                for (std::size_t i = 0; i < 3; ++i) {
                    const Place &from = patch.outline[abc[i]], &to = patch.outline[abc[(i + 1) % 3]];
                    sides[i] = twice_area({16 * from.x, 16 * from.y}, {16 * to.x, 16 * to.y}, point);
                }
                const std::int64_t least = *std::min_element(sides.begin(), sides.end());
                inside += least > 0 ? 1 : 0;
                on_edge += least == 0 ? 1 : 0;
            }
            const bool is_covered = patch.cells.contains(by_least_corner(cell));
            if (on_edge == 0) CHECK(inside == (is_covered ? 1 : 0));
            else CHECK((is_covered && inside == 0 && on_edge == 2));
        }
    }
}

TEST_CASE("A spiral of twelve thousand corners, upright and turned, takes no time to speak of") {
    const Outline upright = spiral(1500);
    REQUIRE(upright.size() == 12000);
    for (const Outline& outline : {upright, mapped(upright, 34, 55, 55, 89)}) {
        const auto start = std::chrono::steady_clock::now();
        const Triangles triangles = triangulate(in_space(outline, 0));
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        CHECK(seconds.count() < 5);  // it takes about 0.01; cutting only ears took a minute
        CHECK(triangles.size() == outline.size() - 2);
        std::int64_t sum = 0;
        for (const auto& [a, b, c] : triangles) {
            const std::int64_t area = twice_area(outline[a], outline[b], outline[c]);
            sum += std::abs(area);
            if (area == 0 || (area > 0) != (twice_area(outline) > 0)) FAIL("a triangle is flat or turned over");
        }
        CHECK(sum == std::abs(twice_area(outline)));
    }
}
