// margin, side and tests are measured without testing every ray against every surface. They must be what the plain loop
// tells, bit for bit.
#include <doctest.h>

#include <cmath>
#include <cstring>

#include "../numerics/doubles.hpp"
#include "render/measure/deciding_triangles.hpp"
#include "render/measure/known_zeros.hpp"
#include "render/measure/pixel_numbers.hpp"
#include "render/render.hpp"
#include "render/trace_pixels.hpp"
#include "scene/scene_file.hpp"

using namespace glassbox;

namespace {

constexpr std::array measured_ones{"margin", "side", "tests", "deficit", "identity"};
constexpr std::array rounding_scalars{Scalar::certified, Scalar::float_, Scalar::double_, Scalar::long_double};

std::vector<const Measurement*> wanted() {
    std::vector<const Measurement*> all;
    for (const char* name : measured_ones) all.push_back(find_measurement(name));
    return all;
}

/// What a probe hears in the plain loop, pixel by pixel, of each measurement.
std::vector<std::vector<double>> told_by_loop(const Scene& scene, Options options) {
    options.engine = EngineChoice::plain;
    const KnownZeros known_zeros(scene, options);
    std::vector<std::vector<double>> values(measured_ones.size(),
                                            std::vector<double>(pixel_count(scene.width, scene.height)));
    trace_pixels<WithTriangles>(
        scene, options, {}, [&](int x, int y, const Ray<double>& ray, Rgb, WithTriangles& probe) {
            known_zeros.take_into(ray, probe.numbers.triangles);
            for (std::size_t m = 0; m < values.size(); ++m)
                values[m][index_of({x, y}, scene.width)] = wanted()[m]->read(probe.numbers).front();
        });
    return values;
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); }

void check_against_loop(const Scene& scene, const Options& options) {
    const auto told = told_by_loop(scene, options);
    const auto channels = measure(scene, options, wanted());
    for (std::size_t m = 0; m < told.size(); ++m) {
        std::size_t different = 0;
        for (std::size_t i = 0; i < told[m].size(); ++i) different += !same_bits(channels[m][0].values[i], told[m][i]);
        const std::string name = measured_ones[m];
        CAPTURE(name);
        CHECK(different == 0);
    }
}

void check_in_all_scalars(const Scene& scene, Options options = {}) {
    for (const Scalar scalar : rounding_scalars) {
        CAPTURE(scalar);
        options.scalar = scalar;
        check_against_loop(scene, options);
    }
}

Vec3<double> some_point(test::Doubles& random, bool whole) {
    const auto coordinate = [&] {
        if (whole) return static_cast<double>(random.below(9)) - 4;
        return random.one_in(20) ? 0.0 : 8 * random.fraction() - 4;
    };
    return {coordinate(), coordinate(), coordinate()};
}

/// Of a triangle that may have no area, a corner that others have, or a size that differs from theirs by far.
ColoredTriangle some_triangle(test::Doubles& random, const std::vector<ColoredTriangle>& before, bool whole) {
    const double size = random.one_in(3) ? 1 : random.positive(-12, 0);
    Vec3<double> A = some_point(random, whole);
    if (!before.empty() && random.one_in(2)) A = before[random.below(before.size())].vertices[random.below(3)];
    Vec3<double> B = A + size * some_point(random, whole), C = A + size * some_point(random, whole);
    if (!before.empty() && random.one_in(2)) B = before[random.below(before.size())].vertices[random.below(3)];
    if (random.one_in(15)) B = A;
    if (random.one_in(15)) C = 0.5 * A + 0.5 * B;
    if (random.one_in(30)) C = random.positive(20, 40) * C;
    return {{A, B, C}, {1, 2, 3}};
}

/// Triangles and a sphere before a view of some kind; whole numbers put rays exactly on edges and corners.
Scene some_scene(test::Doubles& random) {
    Scene scene;
    // Not all blocks of 32 x 32 pixels are full, and not all patches halve evenly.
    scene.width = 1 + static_cast<int>(random.below(45));
    scene.height = 1 + static_cast<int>(random.below(40));
    const bool whole = random.one_in(3);
    const std::uint64_t count = random.below(60);
    for (std::uint64_t i = 0; i < count; ++i) scene.triangles.push_back(some_triangle(random, scene.triangles, whole));
    if (count > 0 && random.one_in(4)) scene.triangles.push_back(scene.triangles[random.below(count)]);
    scene.spheres = {{{0, 0, 0}, 0.5, {1, 1, 1}}};
    const double pixel = whole ? 0.25 : 0.2 + 0.1 * random.fraction();
    switch (random.below(3)) {
        case 0:
            scene.view = ParallelView{{-5, -5, 6}, {pixel, 0, 0}, {0, pixel, 0}, {0, 0, -random.positive(-3, 3)}};
            break;
        case 1:
            scene.view = ParallelView{some_point(random, whole), pixel * some_point(random, whole),
                                      pixel * some_point(random, whole), some_point(random, whole)};
            break;
        default: {
            Vec3<double> eye = random.one_in(3) ? some_point(random, whole) : 4.0 * some_point(random, whole);
            if (count > 0 && random.one_in(8)) eye = scene.triangles[0].vertices[0];
            scene.view = PinholeView{eye, some_point(random, whole), {0, 0, 1}, 20 + 80 * random.fraction()};
        }
    }
    return scene;
}

/// All lengths of the scene times a number.
Scene scaled(Scene scene, double by) {
    for (ColoredTriangle& triangle : scene.triangles)
        for (Vec3<double>& corner : triangle.vertices) corner = by * corner;
    for (ColoredSphere& sphere : scene.spheres) {
        sphere.center = by * sphere.center;
        sphere.radius *= by;
    }
    if (auto* const parallel = std::get_if<ParallelView>(&scene.view)) {
        parallel->corner = by * parallel->corner;
        parallel->right = by * parallel->right;
        parallel->up = by * parallel->up;
    } else {
        auto& pinhole = std::get<PinholeView>(scene.view);
        pinhole.eye = by * pinhole.eye;
        pinhole.look_at = by * pinhole.look_at;
    }
    return scene;
}

Scene scene_of(const char* name, int width, int height) {
    return resized(read_scene(std::string(SCENES "/") + name + ".toml"), width, height);
}

}  // namespace

TEST_CASE("the scenes that come along: what is measured without the loop is what the loop tells") {
    for (const char* name : {"room", "edges", "fan", "inside", "levental-2014", "mesh-far", "spheres-far",
                             "tolerance-huge", "tolerance-tiny", "triangle", "turned-36"}) {
        CAPTURE(name);
        check_in_all_scalars(scene_of(name, 41, 33));
    }
}

TEST_CASE("pictures of one pixel, stages without triangles, rules without side products, exact arithmetic") {
    check_in_all_scalars(scene_of("room", 1, 1));
    const Scene fan = scene_of("fan", 40, 30);
    for (const int stage : {1, 2, 3}) {
        Options options;
        options.stage = stage;
        check_in_all_scalars(fan, options);
    }
    for (const TriangleRule& rule : {TriangleRule(Tolerance{}), TriangleRule(MoellerTrumbore{})}) {
        Options options;
        options.triangle_rule = rule;
        check_in_all_scalars(fan, options);
    }
    Options exact;
    exact.scalar = Scalar::exact;
    check_against_loop(scene_of("fan", 12, 9), exact);
}

TEST_CASE("random scenes of ordinary size") {
    test::Doubles random(1);
    for (int n = 0; n < 60; ++n) {
        CAPTURE(n);
        check_in_all_scalars(some_scene(random));
    }
}

TEST_CASE("random scenes of all sizes that doubles have") {
    test::Doubles random(2);
    for (int n = 0; n < 80; ++n) {
        const double size = std::pow(10, static_cast<double>(random.below(601)) - 300);
        CAPTURE(n);
        CAPTURE(size);
        Scene scene = scaled(some_scene(random), size);
        scene.width = 1 + scene.width / 2;
        if (auto* const parallel = std::get_if<ParallelView>(&scene.view); parallel && random.one_in(2))
            parallel->direction = std::pow(10, static_cast<double>(random.below(601)) - 300) * parallel->direction;
        check_in_all_scalars(scene);
    }
}

TEST_CASE("rays that are no rays, and triangles with corners where floats end") {
    Scene scene;
    scene.width = scene.height = 35;
    scene.triangles = {{{Vec3<double>{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {1, 2, 3}},
                       {{Vec3<double>{0, 0, 0}, {1e39, 0, 0}, {0, 1e-46, 0}}, {1, 2, 3}},
                       {{Vec3<double>{1e300, 0, 0}, {0, 1e300, 0}, {0, 0, 1e-300}}, {1, 2, 3}}};
    scene.view = ParallelView{{-1, -1, 1}, {0.125, 0, 0}, {0, 0.125, 0}, {0, 0, 0}};
    check_in_all_scalars(scene);
    scene.view = ParallelView{{-1, -1, 1}, {1e308, 0, 0}, {0, 0.125, 0}, {0, 0, -1}};
    check_in_all_scalars(scene);
    scene.view = ParallelView{{-1, -1, 1}, {0.125, 0, 0}, {0, 0.125, 0}, {0, 0, -1}};
    check_in_all_scalars(scene);
}

TEST_CASE("few triangles are left of many") {
    // Two at least, where an edge that two have is the least certain: their side products differ in sign alone.
    const Scene room = scene_of("room", 64, 64);
    std::vector<Triangle<double>> triangles = surfaces<double>(room, 5).triangles;
    const View seen = view(room, {});
    for (const OfSides asked : {OfSides::least, OfSides::least_certain}) {
        const DecidingTriangles deciding(triangles, Scalar::certified, asked);
        std::size_t left = 0;
        deciding.for_each_pixel(seen, 64, {0, 64, 0, 64}, [&](int, int, std::span<const std::uint32_t> numbers) {
            CHECK(!numbers.empty());
            left += numbers.size();
        });
        CHECK(left < 3 * 64 * 64);  // of 1252 each
    }
}
