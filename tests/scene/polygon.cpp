#include "scene/polygon.hpp"

#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace glassbox;

namespace {

using Point = Vec3<double>;
using Polygon = std::vector<Point>;
using Triangles = std::vector<std::array<std::size_t, 3>>;

Point twice_area(const Point& a, const Point& b, const Point& c) { return cross(b - a, c - a); }

/// Twice the polygon's area, as a vector along its normal.
Point twice_area(const Polygon& polygon) {
    Point sum;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) sum = sum + twice_area(polygon[0], polygon[i], polygon[i + 1]);
    return sum;
}

/// Whether the triangles fill the polygon without overlap: there are n − 2 of them, none is turned over or flat, and
/// their areas add up to the polygon's. (Were one outside, the others would have to overlap, and the sum be too large.)
bool fills(const Triangles& triangles, const Polygon& polygon) {
    const Point whole = twice_area(polygon);
    double sum = 0;
    for (const auto& [a, b, c] : triangles) {
        const Point part = twice_area(polygon[a], polygon[b], polygon[c]);
        if (!(dot(part, whole) > 0)) return false;
        sum += length(part);
    }
    return triangles.size() == polygon.size() - 2 && std::abs(sum / length(whole) - 1) < 1e-12;
}

}  // namespace

TEST_CASE("A triangle stays as it is") {
    CHECK(triangulate(Polygon{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}) == Triangles{{0, 1, 2}});
}

TEST_CASE("A convex polygon becomes the fan about its first corner, either way round, in any plane") {
    Polygon hexagon;
    for (int k = 0; k < 6; ++k) {
        const double angle = k * std::numbers::pi / 3;
        hexagon.push_back({std::cos(angle), std::sin(angle), 2 + std::cos(angle) - 3 * std::sin(angle)});
    }
    const Triangles fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
    CHECK(triangulate(hexagon) == fan);
    CHECK(triangulate(Polygon(hexagon.rbegin(), hexagon.rend())) == fan);
    for (auto& [x, y, z] : hexagon) std::swap(x, z);
    CHECK(triangulate(hexagon) == fan);
    for (auto& [x, y, z] : hexagon) std::swap(y, z);
    CHECK(triangulate(hexagon) == fan);
}

TEST_CASE("Concave polygons are filled exactly, from whatever corner the list starts, at every scale") {
    const Polygon dart{{0, 2, 0}, {0, 1, 0}, {2, 0, 0}, {3, 3, 0}};
    const Polygon arrow{{0, 0, 0}, {4, 2, 0}, {0, 4, 0}, {1, 2, 0}};
    // The letter E, as tall as 5 and as wide as 3, and a comb with its teeth cut to points.
    const Polygon letter{{0, 0, 1}, {3, 0, 1}, {3, 1, 1}, {1, 1, 1}, {1, 2, 1}, {2, 2, 1},
                         {2, 3, 1}, {1, 3, 1}, {1, 4, 1}, {3, 4, 1}, {3, 5, 1}, {0, 5, 1}};
    const Polygon comb{{0, 0, 0}, {0, 6, 0}, {0, 6, 5}, {0, 5, 1}, {0, 4, 5},
                       {0, 3, 1}, {0, 2, 5}, {0, 1, 1}, {0, 0, 5}};
    for (const Polygon& polygon : {dart, arrow, letter, comb}) {
        for (const double scale : {1.0, 1e-160, 1e150}) {
            Polygon scaled;
            for (const auto& corner : polygon) scaled.push_back(scale * corner);
            for (std::size_t start = 0; start < polygon.size(); ++start) {
                // Areas are taken on the unscaled polygon: at 1e150 their squares would overflow.
                Polygon turned = polygon;
                std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(start), turned.end());
                std::rotate(scaled.begin(), scaled.begin() + (start == 0 ? 0 : 1), scaled.end());
                CHECK(fills(triangulate(scaled), turned));
                const Polygon back(turned.rbegin(), turned.rend());
                CHECK(fills(triangulate(back), back));
            }
        }
    }
}

TEST_CASE("A corner in the middle of an edge gives no flat triangle: its neighbours' edges still meet") {
    // A square with one more corner, (1, 0), on its lower edge.
    const Polygon square{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    CHECK(fills(triangulate(square), square));
}

TEST_CASE("A hole, joined to the outside by a cut that is walked twice") {
    const Polygon frame{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                        {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
    const Triangles triangles = triangulate(frame);
    CHECK(length(twice_area(frame)) == 2 * (16 - 4));
    CHECK(fills(triangles, frame));
}

TEST_CASE("What has no area gives no triangle") {
    CHECK(triangulate(Polygon(5, Point{1, 2, 3})).empty());
    CHECK(triangulate(Polygon{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).empty());
    CHECK(triangulate(Polygon{{0, 0, 0}, {1, 2, 3}, {0, 0, 0}, {1, 2, 4}}).empty());
}

TEST_CASE("A corner twice, and an edge walked there and back, add nothing") {
    // A square of four corners, n − 2 = 2 triangles, and one at which the outline stands still, or from which it goes
    // out.
    CHECK(triangulate(Polygon{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}).size() == 2);
    CHECK(triangulate(Polygon{{0, 0, 0}, {1, 0, 0}, {5, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}).size() == 2);
}

TEST_CASE("Where an outline crosses itself at one of its corners, both sides are filled, each its own way round") {
    CHECK(triangulate(Polygon{{0, 0, 0}, {2, 2, 0}, {3, 3, 0}, {3, 1, 0}, {2, 2, 0}, {0, 3, 0}}) ==
          Triangles{{0, 1, 5}, {1, 2, 3}});
}

TEST_CASE("An outline that crosses itself gives at most n - 2 triangles, and an end") {
    CHECK(triangulate(Polygon{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size() == 2);
    CHECK(triangulate(Polygon{{1e308, 0, 0}, {-1e308, 1e308, 0}, {-1e308, -1e308, 0}, {1e308, -1e308, 0}}).size() == 2);
    Polygon star;
    for (int k = 0; k < 5; ++k)
        star.push_back({std::cos(k * 4 * std::numbers::pi / 5), std::sin(k * 4 * std::numbers::pi / 5), 0});
    CHECK(triangulate(star).size() == 3);
}

TEST_CASE("Thousands of corners, all crossed, come to an end soon") {
    Polygon star;
    for (int k = 0; k < 12001; ++k) {
        const double angle = k * 6000 * 2 * std::numbers::pi / 12001;
        star.push_back({std::cos(angle), std::sin(angle) * (1 + 0.001 * (k % 7)), 0});
    }
    CHECK(triangulate(star).size() <= 12001 - 2);
}

TEST_CASE("A disk of ten thousand corners takes no time to speak of") {
    Polygon disk;
    for (int k = 0; k < 10000; ++k)
        disk.push_back({0, std::cos(k * 2 * std::numbers::pi / 10000), std::sin(k * 2 * std::numbers::pi / 10000)});
    CHECK(triangulate(disk).size() == 9998);
}
