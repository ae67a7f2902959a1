// The hierarchy: each surface in one leaf, each box around everything below it, identical for any number of threads.
#include "engine/hierarchy.hpp"

#include <doctest.h>

#include <algorithm>

#include "../certified/cases.hpp"
#include "engine/engine.hpp"
#include "render/search/surfaces.hpp"

using namespace glassbox;
using namespace glassbox::engine;

namespace {

/// Surfaces of all sorts: small, large, alike, flat, far from each other.
Surfaces<double> many(std::size_t count) {
    test::Rays rays(3);
    Surfaces<double> all;
    for (std::size_t i = 0; i < count; ++i) {
        const double scale = rays.random.positive(-30, 3);
        const Vec3<double> at = i % 3 == 0 ? Vec3<double>{1, 2, 3} : rays.random.positive(-4, 8) * rays.anywhere();
        if (i % 4 == 0) all.spheres.push_back({at, scale});
        else if (i % 9 == 1) all.triangles.push_back({at, at, at});
        else
            all.triangles.push_back(
                {at + scale * rays.anywhere(), at + scale * rays.anywhere(), at + scale * rays.anywhere()});
    }
    return all;
}

/// Whether v − middle, never rounded, lies between two floats. Compares their sum with the middle exactly: v − (middle
/// + f) is rounded correctly, so it has the right sign where middle + f is exact; the long double keeps 11 bits more.
bool between(double lo, double hi, double middle, float box_lo, float box_hi) {
    const long double m = middle;
    return static_cast<long double>(lo) - m >= static_cast<long double>(box_lo) &&
           static_cast<long double>(hi) - m <= static_cast<long double>(box_hi);
}

/// Counts the surfaces of leaves, and those that lie outside the boxes above them.
struct Inspection {
    const Engine& engine;
    std::vector<int> seen;
    int outside = 0;

    void inspect(std::uint32_t child, const float (&lo)[3], const float (&hi)[3]) {
        const Hierarchy& tree = engine.hierarchy();
        if (!Child::is_leaf(child)) {
            const Node& node = tree.nodes[child];
            for (int i = 0; i < fan_out; ++i) {
                if (node.child[i] == Child::nothing) continue;
                const float its_lo[3] = {node.side[Node::lo][0][i], node.side[Node::lo][1][i],
                                         node.side[Node::lo][2][i]};
                const float its_hi[3] = {node.side[Node::hi][0][i], node.side[Node::hi][1][i],
                                         node.side[Node::hi][2][i]};
                for (int k = 0; k < 3; ++k) outside += its_lo[k] < lo[k] || its_hi[k] > hi[k];
                inspect(node.child[i], its_lo, its_hi);
            }
            return;
        }
        const bool spheres = Child::is_of_spheres(child);
        const Leaf leaf = (spheres ? tree.sphere_leaves : tree.triangle_leaves)[Child::index(child)];
        CHECK(leaf.count >= 1);
        CHECK(leaf.count <= fan_out);
        for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
            const std::uint32_t surface = tree.surfaces[i];
            ++seen[surface];
            const Vec3<double> m = engine.middle();
            const auto inside = [&](const Vec3<double>& given, double its_r) {
                const Vec3<double> v = engine.scale() * given;
                const double r = engine.scale() * its_r;
                return between(v.x - r, v.x + r, m.x, lo[0], hi[0]) && between(v.y - r, v.y + r, m.y, lo[1], hi[1]) &&
                       between(v.z - r, v.z + r, m.z, lo[2], hi[2]);
            };
            engine.with_surface(surface, [&]<class Surface>(const Surface& s) {
                if constexpr (std::is_same_v<Surface, Sphere<double>>) outside += !inside(s.C, s.r);
                else outside += !inside(s.A, 0) + !inside(s.B, 0) + !inside(s.C, 0);
            });
            if (!spheres) CHECK(engine.blocks()[Child::index(child)].surface[i - leaf.first] == surface);
        }
    }
};

}  // namespace

TEST_CASE("every surface is in one leaf, and in every box above it, but for copies") {
    for (const std::size_t count : std::initializer_list<std::size_t>{1, 2, 7, 8, 9, 100, 3000}) {
        Surfaces<double> all = many(count);
        const Engine engine(all.spheres, all.triangles, 1);
        CAPTURE(count);
        REQUIRE(engine.size() == count);
        Inspection inspection{engine, std::vector<int>(count), 0};
        inspection.inspect(0, engine.around().lo, engine.around().hi);
        for (const Copy& copy : engine.copies()) {
            CHECK(inspection.seen[copy.surface] == 0);
            CHECK(copy.of > copy.surface);
            ++inspection.seen[copy.surface];
        }
        CHECK(std::all_of(inspection.seen.begin(), inspection.seen.end(), [](int times) { return times == 1; }));
        CHECK(inspection.outside == 0);
    }
}

TEST_CASE("surfaces come out as they went in") {
    const Surfaces<double> all = many(500);
    const Engine engine(all.spheres, all.triangles, 1);
    for (std::size_t i = 0; i < all.triangles.size(); ++i) {
        const Triangle<double> t = engine.triangle(all.spheres.size() + i);
        CHECK((t.A == all.triangles[i].A && t.B == all.triangles[i].B && t.C == all.triangles[i].C));
    }
}

TEST_CASE("of surfaces that are the same the last is kept, and the others are its copies") {
    const Triangle<double> one{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, turned{one.B, one.C, one.A},
        mirrored{one.B, one.A, one.C};
    // In one plane and one box, but another triangle.
    const Triangle<double> other{{1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<Sphere<double>> spheres{{{0, 0, 0}, 1}, {{0, 0, 0}, 2}, {{0, 0, 0}, 1}};
    const std::vector<Triangle<double>> triangles{one, other, turned, mirrored};
    const Engine engine(spheres, triangles, 1);
    // Spheres are numbers 0 to 2, triangles 3 to 6: 0 is the same as 2, and 3 and 5 the same as 6.
    const std::vector<Copy>& copies = engine.copies();
    REQUIRE(copies.size() == 3);
    CHECK((copies[0].of == 2 && copies[0].surface == 0));
    CHECK((copies[1].of == 6 && copies[1].surface == 3));
    CHECK((copies[2].of == 6 && copies[2].surface == 5));
    CHECK(engine.copies_of(6).size() == 2);
    CHECK(engine.copies_of(4).empty());
    CHECK(engine.triangle(3).A == one.A);
    CHECK(engine.triangle(5).A == turned.A);
}

TEST_CASE("surfaces too large for floats are in no leaf") {
    Surfaces<double> all = many(20);
    all.triangles.push_back({{0, 0, 0}, {1e300, 0, 0}, {0, 1, 0}});
    all.spheres.push_back({{0, 0, 0}, 1e40});
    const Engine engine(all.spheres, all.triangles, 1);
    // The last sphere, and the last triangle.
    CHECK(engine.loose() == std::vector<std::uint32_t>{static_cast<std::uint32_t>(all.spheres.size() - 1), 21});
    CHECK(engine.triangle(21).B == Vec3<double>{1e300, 0, 0});
}

TEST_CASE("any number of threads builds the same") {
    const Surfaces<double> all = many(20'000 / test::share);
    const Engine one(all.spheres, all.triangles, 1), four(all.spheres, all.triangles, 4);
    CHECK(one.hierarchy().surfaces == four.hierarchy().surfaces);
    CHECK(one.hierarchy().nodes.size() == four.hierarchy().nodes.size());
}

TEST_CASE("no surfaces, no nodes") {
    const Engine none({}, {}, 1);
    CHECK(none.hierarchy().nodes.empty());
    CHECK(none.size() == 0);
}

TEST_CASE("floats are rounded to the safe side") {
    for (const double x : {0.0, 0.1, -0.1, 1.0, 1e-50, -1e-50, 1e30, 3.0000001}) {
        CHECK(static_cast<double>(rounded_down(x)) <= x);
        CHECK(static_cast<double>(rounded_up(x)) >= x);
        CHECK(std::nextafter(rounded_down(x), Box::inf) >= rounded_up(x));
    }
    CHECK(rounded_up(1e300) == Box::inf);
    CHECK(rounded_down(1e300) == std::numeric_limits<float>::max());
}
