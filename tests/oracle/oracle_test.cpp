// The oracle itself, by cases whose answers are obvious.
#include "oracle/oracle.hpp"

#include <doctest.h>

#include <cmath>
#include <limits>

using oracle::Answer, oracle::Oracle, oracle::Point, oracle::Ray, oracle::Surfaces;

namespace {

/// Radius 5 at the origin; the triangle (0,0,−8) (4,0,−8) (0,4,−8).
Surfaces simple() { return {{{{0, 0, 0}, 5}}, {{{0, 0, -8}, {4, 0, -8}, {0, 4, -8}}}}; }

Answer ask(const Ray& ray) { return Oracle(simple())(ray); }

bool is_met_at(const Oracle& oracle, const Ray& ray, std::size_t surface, double t) {
    const Answer answer = oracle(ray);
    return answer.first && answer.first->surface == surface && oracle.compare(ray, *answer.first, {t}) == 0;
}
bool is_met_at(const Ray& ray, std::size_t surface, double t) { return is_met_at(Oracle(simple()), ray, surface, t); }

constexpr Point down{0, 0, -1}, up{0, 0, 1};

}  // namespace

TEST_CASE("spheres: from outside, from inside, from the surface, tangent, beyond") {
    CHECK(is_met_at({{9, 0, 0}, {-1, 0, 0}}, 0, 4));
    CHECK(is_met_at({{9, 0, 0}, {-0.5, 0, 0}}, 0, 8));
    CHECK(is_met_at({{2, 0, 0}, {1, 0, 0}}, 0, 3));
    CHECK(is_met_at({{2, 0, 0}, {-1, 0, 0}}, 0, 7));
    CHECK(is_met_at({{3, 4, 0}, {-3, -4, 0}}, 0, 2));  // from (3, 4, 0) to (−3, −4, 0)
    CHECK(ask({{3, 4, 0}, {3, 4, 0}}).met.empty());
    CHECK(ask({{3, 4, 0}, {-4, 3, 0}}).met.empty());                        // touches it at t = 0 only
    CHECK(is_met_at({{3 + 8, 4 - 6, 0}, {-4, 3, 0}}, 0, 2));                // touches it in (3, 4, 0)
    CHECK(ask({{3 + 8, 4 - 6 + 0x1p-51, 0}, {-4, 3, 0}}).met.empty());      // an ulp outwards
    CHECK(ask({{3 + 8, 4 - 6 - 0x1p-51, 0}, {-4, 3, 0}}).met.size() == 1);  // an ulp inwards
    CHECK(ask({{9, 0, 0}, {1, 0, 0}}).met.empty());
}

TEST_CASE("a root that no double can say: √(25 − 1) from (1, 0, 0) along z") {
    const Oracle oracle(simple());
    const Ray ray{{1, 0, 0}, up}, longer{{0, 1, 0}, {0, 0, 2}}, same{{0, 1, 0}, up};
    const auto met = oracle(ray).first, met_by_longer = oracle(longer).first, met_by_same = oracle(same).first;
    REQUIRE(met);
    REQUIRE(met_by_longer);
    REQUIRE(met_by_same);
    const double root = std::sqrt(24.0);  // rounded: its square is not 24
    CHECK(oracle.compare(ray, *met, {root}) == (std::fma(root, root, -24.0) < 0 ? 1 : -1));
    CHECK(oracle.compare(same, *met_by_same, {root}) == oracle.compare(ray, *met, {root}));
    CHECK(oracle.compare(longer, *met_by_longer, {root / 2}) == oracle.compare(ray, *met, {root}));
    const auto error = static_cast<double>(oracle.error_of(ray, *met, root));
    CHECK(error == doctest::Approx(static_cast<double>(std::abs(std::sqrt(24.0L) - root))).epsilon(1e-3));
    CHECK(oracle.is_within(ray, *met, root, std::nextafter(root, 9) - root));
    CHECK(!oracle.is_within(ray, *met, root, 0));
    CHECK(oracle.t_text(ray, *met, 20) == "4.8989794855663561964");  // √24
}

TEST_CASE("triangles: inside, edges, vertices, outside, behind, edge-on") {
    CHECK(is_met_at({{1, 1, -6}, down}, 1, 2));
    CHECK(is_met_at({{1, 1, -9}, up}, 1, 1));
    for (const Point& on : {Point{0, 0, -7}, {4, 0, -7}, {0, 4, -7}, {2, 0, -7}, {0, 1, -7}, {2, 2, -7}})
        CHECK(is_met_at({on, down}, 1, 1));
    for (const Point& off : {Point{-0x1p-1000, 1, -7}, {1, -0x1p-1000, -7}, {2, 2 + 0x1p-51, -7}, {5, 0, -7}})
        CHECK(ask({off, down}).met.empty());
    CHECK(ask({{1, 1, -8}, down}).met.empty());
    CHECK(ask({{1, 1, -9}, down}).met.empty());
    CHECK(ask({{-1, 1, -8}, {1, 0, 0}}).met.empty());
}

// The weights of (x, y) in the triangle (0,0) (4,0) (0,4), along −z, are 16 − 4x − 4y, 4x and 4y: at (−1, 1) 16, −4
// and 4. The rarer sign has 4 of them.
TEST_CASE("by a tolerance: twice the rarer sign's weights are less than it") {
    const auto is_met = [](double tolerance, const Point& P) { return Oracle(simple(), {tolerance})({P, down}).first; };
    CHECK(!is_met(8, {-1, 1, -7}));
    CHECK(is_met(8 + 0x1p-49, {-1, 1, -7}));
    CHECK(is_met_at(Oracle(simple(), {9}), {{-1, 1, -6}, down}, 1, 2));
    CHECK(is_met(0x1p-1000, {1, 1, -7}));
    CHECK(!is_met(0, {1, 1, -7}));
    CHECK(!is_met(1e300, {1, 1, -9}));  // it lies behind
}

TEST_CASE("all that is met is counted; of equals the last is first") {
    Surfaces surfaces = simple();
    surfaces.triangles.push_back(surfaces.triangles[0]);
    surfaces.triangles.push_back({{0, 0, -5}, {4, 0, -5}, {0, 4, -5}});
    const Oracle oracle(surfaces);
    const Ray outside{{1, 1, -10}, up}, touching{{0, 0, -6}, up};  // the second: the south pole, and a vertex there
    CHECK(oracle(outside).met.size() == 4);
    CHECK(is_met_at(oracle, outside, 2, 2));
    CHECK(oracle(touching).met.size() == 2);
    CHECK(is_met_at(oracle, touching, 3, 1));
}

// In units of 2ᵏ: a sphere of radius 3 about the origin, a triangle in x = 4, and rays that start in x = 6.
TEST_CASE("the same at all scales") {
    for (const int k : {-1072, -700, -537, -170, 170, 511, 1000}) {
        const double s = std::ldexp(1, k);
        const Oracle oracle(Surfaces{{{{0, 0, 0}, 3 * s}}, {{{4 * s, 0, 0}, {4 * s, s, 0}, {4 * s, 0, s}}}});
        CHECK(is_met_at(oracle, {{6 * s, 0, 0}, {-s, 0, 0}}, 1, 2));
        CHECK(oracle(Ray{{6 * s, 0, -s}, {-s, 0, 0}}).met.size() == 1);
        CHECK(is_met_at(oracle, {{6 * s, 0, -3 * s}, {-s, 0, 0}}, 0, 6));  // it touches
    }
}

TEST_CASE("rays that are none") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    CHECK(!ask({{0, 0, 0}, {0, 0, -0.0}}).valid);
    CHECK(!ask({{0, nan, 0}, down}).valid);
    CHECK(!ask({{0, 0, 0}, {0, -inf, 1}}).valid);
    CHECK(ask({{0, 0, 0}, {0, 0, 0x1p-1074}}).valid);
}

TEST_CASE("normals") {
    const Oracle oracle(simple());
    const auto normal = [&](const Ray& ray) { return oracle.normal(ray, *oracle(ray).first).n; };
    const Point of_triangle = normal({{1, 1, -9}, up}), of_sphere = normal({{3, 4, 9}, down});
    CHECK(of_triangle.z == 1);  // counter-clockwise as seen from above
    CHECK(std::abs(of_sphere.x - 0.6) < 1e-15);
    CHECK(std::abs(of_sphere.y - 0.8) < 1e-15);
}

TEST_CASE("the rays of views: where they should be, and a little beside") {
    const oracle::View parallel = oracle::Parallel{{1, 2, 3}, {0.1, 0, 0}, {0, 0.1, 0}, down};
    CHECK(ray_error(parallel, 9, 9, 3, 4, {{1 + 3 * 0.1, 2 + 4 * 0.1, 3}, down}) <= 1);
    CHECK(ray_error(parallel, 9, 9, 3, 4, {{1 + 3 * 0.1 + 0x1p-48, 2 + 4 * 0.1, 3}, down}) > 1);
    CHECK(ray_error(parallel, 9, 9, 3, 4, {{1 + 3 * 0.1, 2 + 4 * 0.1, 3}, up}) > 1);
    // 90° and two pixels: their middles are 1/2 from the axis.
    const oracle::View pinhole = oracle::Pinhole{{5, 0, 0}, {0, 0, 0}, up, 90};
    CHECK(ray_error(pinhole, 2, 2, 1, 0, {{5, 0, 0}, {-1, 0.5, -0.5}}) <= 1);
    CHECK(ray_error(pinhole, 2, 2, 1, 0, {{5, 0, 0}, {-1, 0.5 + 1e-12, -0.5}}) > 1);
    CHECK(ray_error(pinhole, 2, 2, 1, 1, {{5, 0, 0}, {-1, 0.5, -0.5}}) > 1);
}
