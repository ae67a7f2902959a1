// Rays of one's own: verdicts, surfaces, t and hit counts.
#include "render/shoot.hpp"

#include <doctest.h>

#include <limits>

#include "scene/scene_file.hpp"
#include "support/ulps.hpp"

using namespace glassbox;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

/// Unit sphere at the origin (surface 0); a triangle in the plane z = −5 (surface 1); a mesh of two faces in z = −7 (2,
/// 3).
Scene numbered_scene() {
    Scene scene;
    scene.spheres = {{{0, 0, 0}, 1, {}}};
    scene.triangles = {{{Vec3<double>{0, 0, -5}, {4, 0, -5}, {0, 4, -5}}, {}}};
    scene.meshes = {Mesh{{{0, 0, -7}, {4, 0, -7}, {4, 4, -7}, {0, 4, -7}}, {{0, 1, 2}, {0, 2, 3}}, {}}};
    return scene;
}

Shot shot(const Ray<double>& ray, const Options& options = {}) {
    return shoot(numbered_scene(), options, {&ray, 1}).at(0);
}

}  // namespace

TEST_CASE("surfaces are numbered spheres first, then triangles, then mesh faces") {
    const Shot all = shot({{0.25, 0.5, 10}, {0, 0, -1}});
    CHECK(all.answer == Shot::Answer::hit);
    CHECK(all.surface == 0);
    CHECK(all.hits == 3);  // sphere, triangle, and the face 0,2,3 that lies where y > x
    CHECK(shot({{1.5, 1, 10}, {0, 0, -1}}).surface == 1);
    CHECK(shot({{1.5, 1, -6}, {0, 0, -1}}).surface == 2);
    CHECK(shot({{1, 1.5, -6}, {0, 0, -1}}).surface == 3);
}

TEST_CASE("t counts in units of |D|; a surface behind the start, or at it, is not met") {
    const Shot twice = shot({{1.5, 1, 1}, {0, 0, -2}});
    CHECK(twice.surface == 1);
    CHECK(static_cast<double>(twice.t) == 3);      // from z = 1 to −5 in steps of 2
    CHECK(shot({{0, 0, 0}, {0, 0, 0.5}}).t == 2);  // from inside: the far root, 1 away in steps of 0.5
    CHECK(shot({{1.5, 1, -7}, {0, 0, -1}}).answer == Shot::Answer::miss);
    CHECK(shot({{1.5, 1, -8}, {0, 0, -1}}).answer == Shot::Answer::miss);
    CHECK(shot({{1, 0, 3}, {0, 0, -1}}).t == 3);  // tangent: it touches the sphere in (1, 0, 0)
}

TEST_CASE("a ray that is no ray is invalid, never a hit, never a crash") {
    for (const Ray<double>& ray : {Ray<double>{{0, 0, 3}, {0, 0, 0}},
                                   {{not_a_number, 0, 3}, {0, 0, -1}},
                                   {{0, 0, 3}, {0, not_a_number, -1}},
                                   {{0, inf, 3}, {0, 0, -1}},
                                   {{0, 0, 3}, {0, 0, -inf}}}) {
        for (const Scalar scalar : {Scalar::float_, Scalar::double_, Scalar::long_double}) {
            Options options;
            options.scalar = scalar;
            CHECK(shot(ray, options).answer == Shot::Answer::invalid);
            CHECK(shot(ray, options).hits == 0);
        }
    }
}

TEST_CASE("on a shared edge and at equal t the surface listed last wins, and both count") {
    const Shot diagonal = shot({{2, 2, -6}, {0, 0, -1}});  // on the diagonal from vertex 0 to 2
    CHECK(diagonal.surface == 3);
    CHECK(diagonal.hits == 2);
}
