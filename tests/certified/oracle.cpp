// The oracle itself, by cases whose answers can be seen.
#include "oracle.hpp"

#include <doctest.h>

using namespace glassbox;
using oracle::Answer, oracle::compare, oracle::Oracle, oracle::sum;

namespace {

/// Radius 5 at the origin; the triangle (0,0,−8) (4,0,−8) (0,4,−8).
Scene simple_scene() {
    Scene scene;
    scene.spheres = {{{0, 0, 0}, 5, {}}};
    scene.triangles = {{{Vec3<double>{0, 0, -8}, {4, 0, -8}, {0, 4, -8}}, {}}};
    return scene;
}

Answer ask(const Ray<double>& ray) { return Oracle(simple_scene())(ray); }

bool is_met_at(const Answer& answer, std::size_t surface, double t) {
    return answer.first && answer.first->surface == surface && compare(answer.first->t, sum({t})) == 0;
}

constexpr Vec3<double> down{0, 0, -1};

}  // namespace

TEST_CASE("spheres: from outside, from inside, from the surface, tangent, beyond") {
    CHECK(is_met_at(ask({{9, 0, 0}, {-1, 0, 0}}), 0, 4));
    CHECK(is_met_at(ask({{9, 0, 0}, {-0.5, 0, 0}}), 0, 8));
    CHECK(is_met_at(ask({{2, 0, 0}, {1, 0, 0}}), 0, 3));
    CHECK(is_met_at(ask({{2, 0, 0}, {-1, 0, 0}}), 0, 7));
    CHECK(is_met_at(ask({{3, 4, 0}, {-3, -4, 0}}), 0, 2));  // from (3, 4, 0) to (−3, −4, 0)
    CHECK(ask({{3, 4, 0}, {3, 4, 0}}).met.empty());
    CHECK(ask({{3, 4, 0}, {-4, 3, 0}}).met.empty());                        // touches it at t = 0 only
    CHECK(is_met_at(ask({{3 + 8, 4 - 6, 0}, {-4, 3, 0}}), 0, 2));           // touches it in (3, 4, 0)
    CHECK(ask({{3 + 8, 4 - 6 + 0x1p-51, 0}, {-4, 3, 0}}).met.empty());      // an ulp outwards
    CHECK(ask({{3 + 8, 4 - 6 - 0x1p-51, 0}, {-4, 3, 0}}).met.size() == 1);  // an ulp inwards
    CHECK(ask({{9, 0, 0}, {1, 0, 0}}).met.empty());
}

TEST_CASE("a root that no double can say: √(25 − 1) from (1, 0, 0) along z") {
    const Answer answer = ask({{1, 0, 0}, {0, 0, 1}});
    REQUIRE(answer.first);
    const double root = std::sqrt(24.0);  // rounded: its square is not 24
    CHECK(compare(answer.first->t, sum({root})) == (std::fma(root, root, -24.0) < 0 ? 1 : -1));
    // The same root as √6 in steps of 2, from another start.
    const Answer twice = ask({{0, 1, 0}, {0, 0, 2}});
    REQUIRE(twice.first);
    CHECK(static_cast<double>(twice.first->t.size) == std::sqrt(6.0));
    CHECK(compare(twice.first->t, answer.first->t) == -1);
    CHECK(compare(answer.first->t, ask({{0, 1, 0}, {0, 0, 1}}).first->t) == 0);
}

TEST_CASE("triangles: inside, edges, vertices, outside, behind, edge-on") {
    CHECK(is_met_at(ask({{1, 1, -6}, down}), 1, 2));
    CHECK(is_met_at(ask({{1, 1, -9}, -down}), 1, 1));
    for (const Vec3<double>& on : {Vec3<double>{0, 0, -7}, {4, 0, -7}, {0, 4, -7}, {2, 0, -7}, {0, 1, -7}, {2, 2, -7}})
        CHECK(is_met_at(ask({on, down}), 1, 1));
    for (const Vec3<double>& off :
         {Vec3<double>{-0x1p-1000, 1, -7}, {1, -0x1p-1000, -7}, {2, 2 + 0x1p-51, -7}, {5, 0, -7}})
        CHECK(ask({off, down}).met.empty());
    CHECK(ask({{1, 1, -8}, down}).met.empty());
    CHECK(ask({{1, 1, -9}, down}).met.empty());
    CHECK(ask({{-1, 1, -8}, {1, 0, 0}}).met.empty());
}

TEST_CASE("all that is met is counted; of equals the last is first") {
    Scene scene = simple_scene();
    scene.triangles.push_back(scene.triangles[0]);
    scene.triangles.push_back({{Vec3<double>{0, 0, -5}, {4, 0, -5}, {0, 4, -5}}, {}});
    const Oracle oracle(scene);
    const Answer outside = oracle(Ray<double>{{1, 1, -10}, -down});
    CHECK(outside.met.size() == 4);
    CHECK(is_met_at(outside, 2, 2));
    const Answer touching = oracle(Ray<double>{{0, 0, -6}, -down});  // the sphere's south pole, and a vertex there
    CHECK(touching.met.size() == 2);
    CHECK(is_met_at(touching, 3, 1));
}

TEST_CASE("rays that are none") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    CHECK(!ask({{0, 0, 0}, {0, 0, -0.0}}).valid);
    CHECK(!ask({{0, nan, 0}, down}).valid);
    CHECK(!ask({{0, 0, 0}, {0, -inf, 1}}).valid);
    CHECK(ask({{0, 0, 0}, {0, 0, 0x1p-1074}}).valid);
}
