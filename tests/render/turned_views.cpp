// A turned view of a scene equals the view of the scene turned the other way.
#include <doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "render/render.hpp"
#include "render/view.hpp"
#include "scene/scene_file.hpp"

using namespace glassbox;

namespace {

using Point = Vec3<double>;

/// Rodrigues' formula, deliberately not the one of stage 5: v cos + (k × v) sin + k (k·v)(1 − cos), about the unit axis
/// k.
Point rotated(const Point& v, const Point& k, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return std::cos(angle) * v + std::sin(angle) * cross(k, v) + dot(k, v) * (1 - std::cos(angle)) * k;
}

constexpr Point axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// The scene after undoing the turns, last first: everything but the view, the light too.
Scene turned_back(Scene scene, const std::vector<Turn<double>>& turns) {
    const auto back = [&](Point p, const Point& pivot) {
        p = p - pivot;
        for (auto turn = turns.rbegin(); turn != turns.rend(); ++turn)
            p = rotated(p, axes[static_cast<int>(turn->axis)], -turn->degrees);
        return p + pivot;
    };
    for (ColoredSphere& sphere : scene.spheres) sphere.center = back(sphere.center, scene.pivot);
    for (ColoredTriangle& triangle : scene.triangles)
        for (Point& vertex : triangle.vertices) vertex = back(vertex, scene.pivot);
    scene.light_vector = back(scene.light_vector, {});
    return scene;
}

/// Counts the pixels that differ by more than rounding can: by more than 1 in some channel.
std::size_t different_pixels(const Image& a, const Image& b) {
    const auto apart = [](int x, int y) { return std::abs(x - y) > 1; };
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const Rgb p = a.pixels[i], q = b.pixels[i];
        if (apart(p.red, q.red) || apart(p.green, q.green) || apart(p.blue, q.blue)) ++different;
    }
    return different;
}

}  // namespace

TEST_CASE("--turn equals an independent rotation of the whole scene the other way, but for edge pixels") {
    const std::vector<std::vector<Turn<double>>> all{
        {{Axis::z, 10}},
        {{Axis::z, -10}},
        {{Axis::y, 10}},
        {{Axis::y, -20}},
        {{Axis::x, 33}},
        {{Axis::z, 10}, {Axis::y, -20}},
        {{Axis::y, -20}, {Axis::z, 10}},
    };
    Scene scene = read_scene(SCENES "/levental-2014.toml");
    scene.pivot = {100, 350, 250};  // turns about the origin would take the surfaces out of sight
    for (const auto& turns : all) {
        CAPTURE(turns.size());
        CAPTURE(turns[0].degrees);
        Options options;
        options.turns = turns;
        const Image turned = render(scene, options);
        const Image other_way = render(turned_back(scene, turns), {});
        // Outlines of the surfaces are about 700 pixels long; almost none of their pixels is a tie.
        CHECK(different_pixels(turned, other_way) < 25);
        CHECK(different_pixels(turned, render(scene, {})) > 1000);  // the view did turn
    }
}

TEST_CASE("turns are used from stage 5 on") {
    const Scene scene = read_scene(SCENES "/levental-2014.toml");
    Options options;
    options.stage = 4;
    const Image straight = render(scene, options);
    options.turns = {{Axis::z, 10}};
    CHECK(render(scene, options).pixels == straight.pixels);
    options.stage = 5;
    CHECK(render(scene, options).pixels != straight.pixels);
}

TEST_CASE("another size shows the same view") {
    const Scene scene = read_scene(SCENES "/levental-2014.toml");
    // Twice the pixels, half as far apart: the corner stays, and every second pixel of every second row is as before.
    const Scene finer = resized(scene, 1000, 1000);
    const View before = view(scene, {}), after = view(finer, {});
    for (const auto& [x, y] : {std::pair{0, 499}, {0, 0}, {499, 0}, {123, 321}}) {
        const Ray<double> expected = pixel_ray(before, x, y, 500);
        const Ray<double> got = pixel_ray(after, 2 * x, 999 - 2 * (499 - y), 1000);
        CHECK(got.P == expected.P);
        CHECK(got.D == expected.D);
    }
    // Half as wide at the same height: a quarter of the width, 125 pixels, is lost on each side.
    const View narrower = view(resized(scene, 250, 500), {});
    CHECK(pixel_ray(narrower, 0, 0, 500).P == pixel_ray(before, 125, 0, 500).P);
    CHECK(pixel_ray(narrower, 249, 499, 500).P == pixel_ray(before, 374, 499, 500).P);
}

TEST_CASE("accumulated turns agree with rebuilt ones to within the drift, and only they drift") {
    const Scene scene = read_scene(SCENES "/levental-2014.toml");
    Options rebuilt, accumulated;
    rebuilt.turns.assign(36, {Axis::z, 10});
    accumulated.turns = rebuilt.turns;
    accumulated.accumulated = true;
    const auto start = [&](const Options& options) { return pixel_ray(view(scene, options), 499, 0, scene.height).P; };
    const Point from = start({});
    // 36 times 10 degrees are 360, and cos 360° = 1, sin 360° = 0 exactly: not a bit is lost.
    CHECK(start(rebuilt) == from);
    // Each turn rounds coordinates up to 707 a few times.
    const double drift = length(start(accumulated) - from);
    CHECK(drift > 0);
    CHECK(drift < 36 * 8 * 707 * 0x1p-52);
    const Measurement* const what = find_measurement("drift");
    const auto channels = measure(scene, accumulated, std::span(&what, 1));
    CHECK(channels[0][0].values[499] == drift);  // pixel (499, 0)
}

TEST_CASE("quarter turns lose nothing, one by one or all at once") {
    const Scene scene = read_scene(SCENES "/levental-2014.toml");
    for (const bool accumulated : {false, true}) {
        Options options;
        options.accumulated = accumulated;
        options.turns.assign(3, {Axis::z, 90});
        // (500, j, i) turned by 270° about z: (j, −500, i), here with j = i = 499.
        CHECK(pixel_ray(view(scene, options), 499, 0, scene.height).P == Point{499, -500, 499});
    }
}

TEST_CASE("huge angles about one axis are added without overflow") {
    const Scene scene = read_scene(SCENES "/levental-2014.toml");
    Options options;
    options.turns.assign(2, {Axis::z, 1e308});
    CHECK(std::isfinite(pixel_ray(view(scene, options), 0, 0, scene.height).P.x));
}
