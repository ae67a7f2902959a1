// A story against numbers worked out by hand on the paper's scene. Column j and row i are pixel (j, 499 − i), whose ray
// starts at (500, j, i) and runs along (−1, 0, 0).
#include <doctest.h>

#include <cmath>
#include <limits>

#include "explain/explain.hpp"
#include "render/option_names.hpp"
#include "scene/scene_file.hpp"
#include "support/ulps.hpp"

using namespace glassbox;
using namespace glassbox::story;

namespace {

Story tell(int column, int row, const Options& options = {}) {
    return explain(read_scene(SCENES "/levental-2014.toml"), options, column, 499 - row);
}

const SphereTest& sphere(const Story& story, std::size_t row) {
    return std::get<SphereTest>(story.surfaces.at(row).test);
}

const TriangleTest& triangle(const Story& story, std::size_t row) {
    return std::get<TriangleTest>(story.surfaces.at(row).test);
}

}  // namespace

// The test of the surface that is hit is recorded once: its steps are the ones that the hit's begin with.
TEST_CASE("the surface that is hit and the hit tell the same steps, by each rule") {
    Options tolerance, others;
    tolerance.sphere_rule = Textbook{};
    tolerance.triangle_rule = Tolerance{};
    others.sphere_rule = Levental2014{};
    others.triangle_rule = MoellerTrumbore{};
    for (const Options& rules : {Options{}, tolerance, others})
        for (const auto& [column, row] : {std::pair(350, 350), std::pair(350, 100)}) {
            const Story story = tell(column, row, rules);
            REQUIRE(story.hit);
            const std::vector<StoryStep>& steps = story.surfaces.at(story.hit->surface).steps;
            REQUIRE(steps.size() == story.hit->tested_before);
            for (std::size_t i = 0; i < steps.size(); ++i) {
                const StoryStep& of_hit = story.hit->steps.at(i);
                CHECK(steps[i].step.operation == of_hit.step.operation);
                CHECK(steps[i].step.value == of_hit.step.value);
                CHECK((steps[i].name == of_hit.name || of_hit.name.empty()));
                CHECK(steps[i].checked.error == of_hit.checked.error);
            }
        }
}

// The ray through the middle of the green sphere, (100, 350, 350), r = 50: v = P − c = (400, 0, 0), v·D = −400,
// v² − r² = 157500, Δ = 400² − 157500 = 2500, t = 400 ± 50. It arrives at (150, 350, 350), where n = (1, 0, 0).
// l = (4, 1, 1)/√18, so n·l = 4/√18, and green is 255·4/√18 = 240.4. L + r = (1001, 250, 250), and n·h is 1001 over
// its length; its 15th power times 0.2·255 is 21.1. Ambient light is 0.2 (255, 102, 102) = (51, 20.4, 20.4). Each cut:
// (51 + 0 + 21, 20 + 240 + 21, 20 + 0 + 21) = (72, 255, 41), for 281 is held at 255.
TEST_CASE("the middle of the green sphere") {
    const Story story = tell(350, 350);
    CHECK(story.row == 350);
    CHECK(story.color == Rgb{72, 255, 41});
    CHECK(story.tested == 6);
    CHECK(story.met == 1);
    REQUIRE(story.surfaces.size() == 6);
    CHECK(story.surfaces[0].fate == Fate::nearest);
    CHECK(story.surfaces[1].fate == Fate::apart);
    CHECK(story.surfaces[2].fate == Fate::outside);
    for (const RootPair& roots : {sphere(story, 0).textbook, sphere(story, 0).stable}) {
        CHECK(roots.discriminant.value == 2500);
        CHECK(roots.discriminant.sign == 1);
        CHECK(roots.t0->value == 350);
        CHECK(roots.t1->value == 450);
        CHECK(roots.t0->bits_lost == 0);
    }

    REQUIRE(story.hit);
    const FirstHit& hit = *story.hit;
    CHECK(hit.surface == 0);
    CHECK(hit.t.value == 350);
    CHECK(hit.t.truth == 350);
    CHECK(hit.t.error < 1e-11);
    CHECK(hit.point.x.value == 150);
    CHECK(hit.point.y.value == 350);
    CHECK(hit.normal.x.value == 1);
    CHECK(hit.normal.y.value == 0);
    CHECK(hit.normal.z.value == 0);

    REQUIRE(hit.shade);
    const Shade& shade = *hit.shade;
    const double n_l = 4 / std::sqrt(18.0), n_h = 1001 / std::sqrt(1001.0 * 1001 + 2 * 250 * 250);
    CHECK_ULPS(shade.n_l.value, n_l, 4.0);
    CHECK_ULPS(shade.n_l.truth, n_l, 2.0);
    CHECK_ULPS(shade.n_r.value, 1.0, 1.0);
    CHECK_ULPS(shade.highlight.value, n_h, 4.0);
    CHECK(shade.ambient.bytes == Rgb{51, 20, 20});
    CHECK(shade.diffuse.bytes == Rgb{0, 240, 0});
    CHECK(shade.specular.bytes == Rgb{21, 21, 21});
    CHECK_ULPS(shade.diffuse.product.y.value, 255 * n_l, 8.0);
    CHECK_ULPS(shade.specular.factor.value, 0.2 * std::pow(n_h, 15), 32.0);
    CHECK(hit.worst);
    CHECK(hit.worst_loss > 0);
}

// The corner P = (200, 350, 100) of the tetrahedron, seen exactly: t = 300 for both triangles in front that have it,
// PQR and PSR, and the one listed last wins. PQS lies in a plane through the ray. In PQR, with C = R, the side product
// with QR is twice the area seen, 50·50; those with the edges that meet in P are 0.
TEST_CASE("a corner that two triangles share") {
    const Story story = tell(350, 100);
    CHECK(story.met == 2);
    CHECK(story.surfaces[2].fate == Fate::as_near);
    CHECK(story.surfaces[3].fate == Fate::edge_on);
    CHECK(story.surfaces[4].fate == Fate::nearest);
    CHECK(story.surfaces[5].fate == Fate::outside);
    const TriangleTest& PQR = triangle(story, 2);
    CHECK(std::abs(PQR.a.value) == 2500);
    CHECK(PQR.b.sign == 0);
    CHECK(PQR.c.sign == 0);
    CHECK(PQR.deficit.value == 0);
    CHECK(PQR.accepted);
    CHECK((*PQR.weights)[0].value == 1);
    CHECK((*PQR.weights)[1].value == 0);
    CHECK_FALSE(triangle(story, 3).weights);
    CHECK(story.hit->t.value == 300);
    CHECK(story.hit->point.x.value == 200);
}

// One to the left of that corner: PQR's sides have both signs. Its three sums are D·(B × A) with A = (−300, 1, 0),
// B = (−300, 51, 0), C = (−300, 26, 50) and D = (−1, 0, 0), so each is −(B × A)ₓ: a = −(C × B)ₓ = −(26·0 − 50·51) =
// 2550, b = −(A × C)ₓ = −(1·50 − 0·26) = −50, c = 0. The paper's difference is twice the lesser part, 100: no hit, as
// it is not under 10.
TEST_CASE("beside that corner") {
    const Story story = tell(349, 100);
    const TriangleTest& PQR = triangle(story, 2);
    CHECK(PQR.a.value == 2550);
    CHECK(PQR.b.value == -50);
    CHECK(PQR.c.value == 0);
    CHECK(PQR.sum.value == 2500);
    CHECK(PQR.deficit.value == 100);
    CHECK_FALSE(PQR.accepted);
    CHECK(story.surfaces[2].fate == Fate::outside);
    CHECK_FALSE(story.hit);
    CHECK(story.color == Rgb{0, 0, 0});

    Options tolerant;
    tolerant.triangle_rule = Tolerance{101};
    const Story accepted = tell(349, 100, tolerant);
    CHECK(accepted.hit);
    CHECK(triangle(accepted, 2).accepted);
    tolerant.triangle_rule = Tolerance{100};
    CHECK(tell(349, 100, tolerant).surfaces[2].fate == Fate::beyond_tolerance);
}

TEST_CASE("a tangent ray: the discriminant is exactly 0, and it is met") {
    const Story story = tell(400, 350);
    CHECK(sphere(story, 0).stable.discriminant.value == 0);
    CHECK(sphere(story, 0).stable.discriminant.sign == 0);
    CHECK(story.surfaces[0].fate == Fate::nearest);
    CHECK(story.hit->t.value == 400);
}

// By the rule of the paper's program that ray misses, and so does one that starts inside: from x = 100, the middle, the
// green sphere's nearer root is −50. From x = 0 it lies behind altogether.
TEST_CASE("a sphere that the paper's program misses, and why") {
    Options published;
    published.sphere_rule = Levental2014{};
    for (const Scalar scalar : {Scalar::certified, Scalar::double_}) {
        published.scalar = scalar;
        CHECK(tell(350, 350, published).surfaces[0].fate == Fate::nearest);
        const Story touched = tell(400, 350, published);
        CHECK(touched.surfaces[0].fate == Fate::touched);
        CHECK_FALSE(touched.surfaces[0].t);
        CHECK_FALSE(touched.hit);
        CHECK(tell(401, 350, published).surfaces[0].fate == Fate::apart);
        Scene scene = read_scene(SCENES "/levental-2014.toml");
        std::get<ParallelView>(scene.view).corner.x = 100;
        const Story inside = explain(scene, published, 350, 149);
        CHECK(inside.surfaces[0].fate == Fate::from_inside);
        CHECK(inside.surfaces[0].t->value == -50);
        std::get<ParallelView>(scene.view).corner.x = 0;
        CHECK(explain(scene, published, 350, 149).surfaces[0].fate == Fate::behind);
    }
}

TEST_CASE("the border, and what is under it") {
    const Story story = tell(0, 250);
    CHECK(story.border);
    CHECK(story.color == Rgb{255, 0, 0});
    CHECK(story.traced == Rgb{0, 0, 0});
    CHECK_FALSE(tell(1, 250).border);
}

TEST_CASE("surfaces behind the start are missed, and it says so") {
    Scene scene = read_scene(SCENES "/levental-2014.toml");
    std::get<ParallelView>(scene.view).corner.x = 0;
    const Story story = explain(scene, {}, 350, 149);
    CHECK(story.surfaces[0].fate == Fate::behind);
    CHECK(story.surfaces[0].t->value == -50);
    const Story corner = explain(scene, {}, 350, 399);
    CHECK(corner.surfaces[2].fate == Fate::behind);
    CHECK(corner.surfaces[2].t->value == -200);
}

// Side products of 1e400 are beyond all doubles: a double's verdict is lost, and the story says why. Many a
// long double holds them.
TEST_CASE("numbers beyond all doubles") {
    Scene scene = read_scene(SCENES "/levental-2014.toml");
    scene.spheres.clear();
    scene.triangles = {{{Vec3<double>{0, 0, 0}, {0, 1e200, 0}, {0, 0, 1e200}}, {1, 2, 3}}};
    Options options;
    options.scalar = Scalar::double_;
    const Story in_double = explain(scene, options, 300, 200);
    CHECK(in_double.surfaces.at(0).fate == Fate::overflow);
    options.scalar = Scalar::certified;
    const Story certified = explain(scene, options, 300, 200);
    CHECK(certified.surfaces.at(0).fate == Fate::nearest);
    // At an ordinary scale, all lengths multiplied by a power of two, the bounds of doubles decide.
    CHECK(!certified.surfaces.at(0).needed_exact);
    CHECK(certified.hit->t_by_exact);
    CHECK(certified.hit->t.value == 500);
    if (std::numeric_limits<long double>::max_exponent < 2000) return;
    options.scalar = Scalar::long_double;
    const Story in_long_double = explain(scene, options, 300, 200);
    CHECK(in_long_double.surfaces.at(0).fate == Fate::nearest);
    CHECK(in_long_double.hit->t.value == 500);
}

// The far sphere's Δ = r² = 1e-360 is no double: what is left of it is 0, and no bit of that is right.
TEST_CASE("numbers below all doubles") {
    Scene scene = read_scene(SCENES "/levental-2014.toml");
    scene.spheres = {{{0, 250, 250}, 1e-180, {1, 2, 3}}};
    const Story story = explain(scene, {}, 250, 249);
    CHECK(sphere(story, 0).stable.discriminant.value == 0);
    CHECK(sphere(story, 0).stable.discriminant.sign == 1);
    CHECK(sphere(story, 0).stable.discriminant.bits_lost == 53);
}

TEST_CASE("stage 1 has a ray and no surfaces; stages 2 and 3 have no shading") {
    Options options;
    options.stage = 1;
    const Story ray = tell(350, 350, options);
    CHECK(ray.surfaces.empty());
    CHECK(ray.ray_color->y.value == 127.5);  // (350/50 + 350/50) is even: 255/2 (1 + 0)
    CHECK(ray.color == Rgb{0, 128, 128});
    options.stage = 3;
    const Story plain = tell(350, 350, options);
    CHECK(plain.hit);
    CHECK_FALSE(plain.hit->shade);
    CHECK(plain.color == Rgb{0, 255, 0});
}

TEST_CASE("of many surfaces those met are told, and those missed by the least") {
    const Scene scene = read_scene(SCENES "/room.toml");
    const Story story = explain(scene, {}, 100, 200);
    CHECK(story.surfaces.size() == 20);
    CHECK(story.tested == 1255);
    CHECK(story.not_listed == 1235);
    std::size_t met = 0;
    for (const Surface& surface : story.surfaces) met += is_met(surface.fate);
    CHECK(met == story.met);
}

// The line y = z = 250 passes the three spheres' middles, of radius 10: it meets them at t = 500 − x − 10, and the
// first two, which are the same, at the same t. 0.1 apart is farther, in every scalar.
TEST_CASE("of surfaces at the same t the one listed last is seen; a little farther is farther") {
    Scene scene;
    scene.spheres = {{{100, 250, 250}, 10, {}}, {{100, 250, 250}, 10, {}}, {{99.9, 250, 250}, 10, {}}};
    for (const Named<Scalar>& scalar : scalars) {
        CAPTURE(scalar.name);
        Options options;
        options.scalar = scalar.value;
        const Story story = explain(scene, options, 250, 249);
        REQUIRE(story.surfaces.size() == 3);
        CHECK(story.surfaces[0].fate == Fate::as_near);
        CHECK(story.surfaces[1].fate == Fate::nearest);
        CHECK(story.surfaces[2].fate == Fate::farther);
    }
}

// 3000 triangles, one behind the other along the ray: more than the plain loop is used for. They lie at x = 0, −1, …,
// so t = 500 + i.
TEST_CASE("surfaces met are told in the order of their numbers, whatever order they are found in") {
    Scene scene;
    for (int i = 0; i < 3000; ++i) {
        const double x = -(i * 7 % 3000);
        scene.triangles.push_back({{{{x, 200, 200}, {x, 300, 200}, {x, 250, 300}}}, {}});
    }
    const Story story = explain(scene, {}, 250, 249);
    REQUIRE(story.surfaces.size() == 3000);
    for (std::size_t i = 0; i < 3000; ++i) {
        REQUIRE(story.surfaces[i].number == i);
        REQUIRE(story.surfaces[i].t->value == 500 + static_cast<double>(i * 7 % 3000));
    }
    CHECK(story.hit->surface == 0);
}

TEST_CASE("every bound of a story holds") {
    for (const auto& [column, row] : {std::pair{350, 350}, {350, 100}, {375, 115}, {310, 290}, {399, 349}}) {
        const Story story = tell(column, row);
        REQUIRE(story.hit);
        for (const StoryStep& step : story.hit->steps)
            if (step.checked.known != Known::not_at_all) CHECK(step.checked.distance <= step.checked.error);
    }
}

// The tape uses the scalar itself: float's t is a float, found by the steps alone, whatever double would give.
TEST_CASE("in float the story is float's") {
    Options options;
    options.scalar = Scalar::float_;
    int other_than_doubles = 0;
    for (const auto& [column, row] : {std::pair{350, 350}, {375, 115}, {310, 290}, {333, 361}, {399, 349}}) {
        const Story story = tell(column, row, options);
        REQUIRE(story.hit);
        CHECK_FALSE(story.hit->t_by_exact);
        CHECK(static_cast<double>(static_cast<float>(story.hit->t.value)) == story.hit->t.value);
        CHECK(story.hit->t.bits_lost <= 24);
        for (const StoryStep& step : story.hit->steps) {
            if (step.checked.known != Known::not_at_all) CHECK(step.checked.distance <= step.checked.error);
            if (step.step.operation == Operation::input) continue;
            CHECK(static_cast<long double>(static_cast<float>(step.step.value)) == step.step.value);
        }
        other_than_doubles += story.hit->t.value != tell(column, row).hit->t.value;
    }
    CHECK(other_than_doubles > 0);
}
