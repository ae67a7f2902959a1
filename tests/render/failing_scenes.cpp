// The scenes that make numbers fail do fail, by the rules named in their first lines; and certified is right in all of
// their pixels.
#include <doctest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/failing.hpp"
#include "render/measure/measurements.hpp"
#include "render/render.hpp"
#include "render/view.hpp"
#include "scene/scene_file.hpp"

using namespace glassbox;

namespace {

constexpr double wrong_hit = 1, wrong_miss = 2;

Scene read(const char* name) { return read_scene(std::string(SCENES "/") + name + ".toml"); }

Options with(Scalar scalar, TriangleRule triangle_rule = Pluecker{}, SphereRule sphere_rule = Stable{}) {
    Options options;
    options.scalar = scalar;
    options.triangle_rule = triangle_rule;
    options.sphere_rule = sphere_rule;
    return options;
}

/// 36 turns by 10 degrees, added up one by one: rebuilt from all turns at once, the view would be where it was.
Options once_around(Options options) {
    options.turns.assign(36, {Axis::z, 10});
    options.accumulated = true;
    return options;
}

/// Columns left … right − 1 and rows top … bottom − 1.
struct Part {
    int left = 0, right = std::numeric_limits<int>::max();
    int top = 0, bottom = std::numeric_limits<int>::max();
};

/// What one rendering measured: verdict and hits of every pixel.
struct Measured {
    int width, height;
    std::vector<double> verdict, hits;

    Measured(const Scene& scene, const Options& options) : width(scene.width), height(scene.height) {
        const Measurement* const wanted[] = {find_measurement("verdict"), find_measurement("hits")};
        auto channels = measure(scene, options, wanted);
        verdict = std::move(channels[0][0].values);
        hits = std::move(channels[1][0].values);
        REQUIRE(verdict.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    }

    long pixels() const { return long{width} * height; }

    /// Returns how many of the part's pixels have a value that passes the test.
    long count(const std::vector<double>& values, const std::function<bool(double)>& pleases,
               const Part& part = {}) const {
        long found = 0;
        for (int y = part.top; y < std::min(part.bottom, height); ++y)
            for (int x = part.left; x < std::min(part.right, width); ++x)
                found += pleases(values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                        static_cast<std::size_t>(x)]);
        return found;
    }
    long verdicts(const std::function<bool(double)>& pleases, const Part& part = {}) const {
        return count(verdict, pleases, part);
    }
    long with_hits(const std::function<bool(double)>& pleases, const Part& part = {}) const {
        return count(hits, pleases, part);
    }
};

std::function<bool(double)> is(double value) {
    return [value](double x) { return x == value; };
}

bool wrong(double verdict) { return verdict != 0; }
bool odd(double hits) { return static_cast<int>(hits) % 2 == 1; }

}  // namespace

TEST_CASE("certified is right in every pixel of all of them") {
    // Scenes whose pixels need not lie exactly where they do are made smaller.
    const struct {
        const char* name;
        int width, height;
    } scenes[] = {{"tolerance-tiny", 100, 100},  {"tolerance-huge", 100, 100}, {"spheres-far", 240, 120},
                  {"spheres-grazing", 240, 120}, {"mesh-far", 90, 60},         {"edges", 160, 80},
                  {"turned-36", 100, 100}};
    for (const auto& each : scenes) {
        CAPTURE(each.name);
        Options options = with(Scalar::certified);
        if (std::string(each.name) == "turned-36") options = once_around(options);
        const Measured proven(resized(read(each.name), each.width, each.height), options);
        CHECK(proven.verdicts(is(0)) == proven.pixels());
    }
}

TEST_CASE("tolerance-tiny: every ray that misses is taken for a hit") {
    const Scene scene = read("tolerance-tiny");
    const Measured truth(scene, with(Scalar::certified));
    // With the triangle's legs as axes the weights are 1 − x − y, x and y, and x and y go from −1.5 to under 2.5. Twice
    // the smaller of their positive and negative parts is largest at (2.5, 2.5): 2·min(5, 4) = 8, under 10.
    const long misses = truth.with_hits(is(0));
    CHECK(Measured(scene, with(Scalar::double_, Tolerance{})).verdicts(is(wrong_hit)) == misses);
    // The triangle has half a unit of the picture's 16, and 300 pixels are more than lie along its edges.
    CHECK(misses > truth.pixels() / 32 * 31 - 300);
}

TEST_CASE("tolerance-huge: every ray hits, and the rule refuses many") {
    const Scene scene = resized(read("tolerance-huge"), 100, 100);
    const Measured truth(scene, with(Scalar::certified));
    CHECK(truth.with_hits(is(1)) == truth.pixels());
    // The edge's side product is under 2e11, and is rounded from terms near 1e27 with last bits of 1.4e11: many signs
    // are chance. If all were, half would be wrong; a tenth leaves room for the better columns.
    CHECK(Measured(scene, with(Scalar::double_, Tolerance{})).verdicts(is(wrong_miss)) > truth.pixels() / 10);
}

TEST_CASE("spheres-far: in float the textbook's farthest sphere is as wide as half the picture") {
    // 4000 off, v² is near 1.6e7, where floats are 1 apart: v² − r² and (v·D)² come out equal for all l² under a half,
    // l < 0.7. That is so in the whole right half, whose pixels are at most 0.15 and 0.45 to the sides of the middle,
    // (0.45, −0.15), or above and below. It has 240² pixels, and four discs of radius 40 pixels that are truly hit.
    const Measured found(read("spheres-far"), with(Scalar::float_, Pluecker{}, Textbook{}));
    CHECK(found.verdicts(is(wrong_hit), {240}) > 240 * 240 - 4 * 5100);
}

TEST_CASE("spheres-grazing: 20 rays touch each sphere, and what rounding makes of them") {
    const Scene scene = read("spheres-grazing");
    const Measured truth(scene, with(Scalar::certified));
    const Measured floats(scene, with(Scalar::float_)), doubles(scene, with(Scalar::double_));
    // Whole numbers with x² + y² = 25²: (±25, 0) and (0, ±25), (±7, ±24) and (±24, ±7), (±15, ±20) and (±20, ±15): 20.
    constexpr int cell = 60;
    for (int k = 0; k < 3; ++k) {
        CAPTURE(k);
        const Part upper{cell * k, cell * (k + 1), 0, cell}, lower{cell * k, cell * (k + 1), cell};
        CHECK(truth.with_hits(is(1), lower) == truth.with_hits(is(1), upper) - 20);
        // In float the lower radius is the upper. Up to a million off, the numbers of the stable rule's l are whole and
        // have at most 24 bits, so the same rays touch.
        CHECK(floats.verdicts(wrong, upper) == 0);
        CHECK(floats.verdicts(is(wrong_hit), lower) == 20);
    }
    const Measured textbook(scene, with(Scalar::double_, Pluecker{}, Textbook{}));
    // A million lengths of D off v² is 9e12, with doubles 2^-9 apart; the lower r² differs from 75² by 1.4e-7.
    CHECK(textbook.verdicts(wrong, {2 * cell, 3 * cell, 0, cell}) == 0);
    CHECK(textbook.verdicts(is(wrong_hit), {2 * cell, 3 * cell, cell}) == 20);
    // A billion off D²v² is 8.1e19, with doubles 16384 apart. An error e in the discriminant D²(r² − l²) moves the
    // outline by e / (2·9·75): 16384 by 12 units, 4 pixels. A quarter of a pixel all around would make 2π·25 / 4 = 39
    // wrong.
    CHECK(textbook.verdicts(wrong, {3 * cell, 4 * cell, 0, cell}) > 39);
    CHECK(doubles.verdicts(wrong) == 0);  // the numbers of its l are whole, of less than 53 bits
}

TEST_CASE("mesh-far: what rounding does to an edge grows with the square of the distance") {
    const Scene scene = resized(read("mesh-far"), 90, 60);  // a pixel is 0.15 wide, and each has 30 by 30
    const Measured truth(scene, with(Scalar::certified));
    CHECK(truth.with_hits(odd) == 0);  // into a closed mesh and out of it
    // In double an edge moves by u L²: 3e6 units off, by a hundredth of a pixel; 9e7 units off, by 0.9 units or 6
    // pixels. Its outline is over 2π·1.5 units long, 62 pixels.
    const Measured doubles(scene, with(Scalar::double_));
    CHECK(doubles.verdicts(wrong, {0, 90, 0, 30}) + doubles.verdicts(wrong, {0, 30, 30, 60}) < 5);
    CHECK(doubles.verdicts(wrong, {60, 90, 30, 60}) > 62);
    CHECK(doubles.with_hits(odd) > 0);
    // In float u L² is 5000 units and more for the last four: all signs are chance, and each of 80 faces is hit by one
    // ray in four. Hardly a ray misses all.
    const Measured floats(scene, with(Scalar::float_));
    CHECK(floats.verdicts(is(wrong_hit)) > truth.with_hits(is(0)) * 9 / 10);
}

TEST_CASE("edges: on whole numbers all rules are right; a hair off, only Plücker's lets no ray between two faces") {
    const Scene scene = read("edges");
    const Measured truth(scene, with(Scalar::certified));
    const Measured pluecker(scene, with(Scalar::double_)),
        moeller_trumbore(scene, with(Scalar::double_, MoellerTrumbore{}));
    const Part whole{0, 80}, a_hair_off{80, 160};
    // From the near corner, in pixels: four edges of 36 steps, one pixel a step. From the far one: (30, 4), (−6, 40),
    // (−42, 4) and (−6, −32), each with one pixel in its middle. Within an edge two faces of its own side count and one
    // of the other; in a corner four and one; in a corner of the rim four, two on each side.
    CHECK(truth.with_hits(is(3), whole) == 4 * 35 + 4);
    CHECK(truth.with_hits(is(5), whole) == 2);
    CHECK(truth.with_hits(is(4), whole) == 4);
    CHECK(pluecker.verdicts(wrong, whole) == 0);
    CHECK(moeller_trumbore.verdicts(wrong, whole) == 0);
    // Truly no ray of the right half meets an edge or a corner, so that an odd count is a ray lost or doubled.
    CHECK(truth.with_hits(odd, a_hair_off) == 0);
    CHECK(pluecker.with_hits(is(1), a_hair_off) == 0);
    CHECK(moeller_trumbore.with_hits(is(1), a_hair_off) > 0);
    CHECK(moeller_trumbore.verdicts(wrong, a_hair_off) > 0);
}

TEST_CASE("turned-36: the rays drift, and what they meet is still told right") {
    const Scene scene = resized(read("turned-36"), 100, 100);
    const Options options = once_around(with(Scalar::certified));
    const Measurement* const wanted[] = {find_measurement("drift"), find_measurement("verdict")};
    const auto channels = measure(scene, options, wanted);
    // Starts are (500, y, z) with 0 ≤ y, z < 500. A turn mixes x and y, at most 708 in size, by two products and a sum,
    // with a sine and a cosine that are rounded, too; the corner and the step from pixel to pixel are turned, each:
    // under 8 roundings of 708 · 2^-53 a turn. About z nothing happens to z, and a row drifts alike whatever its z is.
    const std::vector<double>& drift = channels[0][0].values;
    const double greatest = *std::max_element(drift.begin(), drift.end());
    CHECK(greatest > 0);
    CHECK(greatest < 36 * 8 * 708 * 0x1p-53);
    long unlike_the_first_row = 0;
    for (std::size_t i = 0; i < drift.size(); ++i) unlike_the_first_row += drift[i] != drift[i % 100];
    CHECK(unlike_the_first_row == 0);
    // The verdict is about the rays as they are.
    CHECK(std::all_of(channels[1][0].values.begin(), channels[1][0].values.end(), is(0)));
}

TEST_CASE("what a scene says makes it fail does so: pixels are wrong by it, or the rays have drifted") {
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(SCENES)) {
        if (entry.path().extension() != ".toml") continue;
        const Scene scene = resized(read_scene(entry.path()), 120, 120);
        const std::optional<Setup> failing = failing_setup(scene, setup_of(scene));
        if (!failing) continue;
        ++scenes;
        CAPTURE(entry.path().stem().string());
        const Measurement* const wanted[] = {find_measurement("verdict"), find_measurement("drift")};
        const auto channels = measure(scene, failing->options, wanted);
        const auto above_0 = [](const Channel& channel) {
            return std::ranges::any_of(channel.values, [](double value) { return value > 0; });
        };
        CHECK((above_0(channels[0][0]) || above_0(channels[1][0])));
    }
    CHECK(scenes >= 7);  // those of docs/failing-scenes.md
}
