// The sphere test of the paper's program with proven answers: the rule's own verdict, without rounding. And how it is
// judged: by the mathematics, from which the rule differs.
#include <doctest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "render/measure/measurements.hpp"
#include "render/option_names.hpp"
#include "render/render.hpp"
#include "render/shoot.hpp"
#include "scene/scene_file.hpp"

using namespace glassbox;

namespace {

Options published(Scalar scalar) {
    Options options;
    options.scalar = scalar;
    options.sphere_rule = Levental2014{};
    return options;
}

/// The same numbers on every machine: the standard fixes its engines, but not its distributions.
class Dice {
public:
    int whole(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }
    Vec3<double> vector(int size) {
        const int x = whole(-size, size), y = whole(-size, size), z = whole(-size, size);
        return {1.0 * x, 1.0 * y, 1.0 * z};
    }

private:
    std::mt19937_64 engine_{11};
};

/// How many pixels have each verdict: right, wrong hit, wrong miss, wrong surface.
std::array<std::size_t, 4> verdicts(const Scene& scene, const Options& options) {
    const Measurement* const wanted = find_measurement("verdict");
    const auto channels = measure(scene, options, {&wanted, 1});
    std::array<std::size_t, 4> counts{};
    for (const double value : channels[0][0].values) ++counts.at(static_cast<std::size_t>(value));
    return counts;
}

constexpr std::size_t right = 0, wrong_miss = 2, wrong_surface = 3;

}  // namespace

// With v = P − c, a = D², b = v·D and k = v² − r² the rule meets a sphere where b² − ak > 0 and its nearer root, (−b −
// √(b² − ak))/a, is above 0: where b < 0 and ak > 0. In whole numbers all of that is exact. Spheres of whole radii
// about whole points are touched often.
TEST_CASE("proven, it is the rule's own verdict, at every scale: whole numbers tell what that is") {
    Dice dice;
    for (const int power : {0, -40, 40, -332, 332}) {  // times 1, 1e−12, 1e12, 1e−100, 1e100
        CAPTURE(power);
        std::size_t met = 0, touched = 0, inside = 0;
        for (int round = 0; round < 20; ++round) {
            Scene scene;
            std::vector<Vec3<double>> centers;
            std::vector<double> radii;
            for (int k = 0; k < 8; ++k) {
                centers.push_back(dice.vector(4));
                radii.push_back(dice.whole(1, 4));
                const Vec3<double> c = centers.back();
                scene.spheres.push_back({{std::ldexp(c.x, power), std::ldexp(c.y, power), std::ldexp(c.z, power)},
                                         std::ldexp(radii.back(), power),
                                         {}});
            }
            std::vector<Ray<double>> rays;
            std::vector<std::size_t> expected;
            for (int n = 0; n < 40; ++n) {
                const Vec3<double> P = dice.vector(4), D = dice.vector(1);
                const double a = dot(D, D);
                if (a == 0) continue;
                rays.push_back({{std::ldexp(P.x, power), std::ldexp(P.y, power), std::ldexp(P.z, power)}, D});
                expected.push_back(0);
                for (std::size_t k = 0; k < centers.size(); ++k) {
                    const Vec3<double> v = P - centers[k];
                    const double b = dot(v, D), c = dot(v, v) - radii[k] * radii[k];
                    expected.back() += b * b - a * c > 0 && b < 0 && c > 0;
                    touched += b * b == a * c && b < 0;
                    inside += c < 0;
                }
                met += expected.back();
            }
            for (const Scalar scalar : {Scalar::certified, Scalar::exact}) {
                CAPTURE(name_of(scalar));
                const std::vector<Shot> shots = shoot(scene, published(scalar), rays);
                for (std::size_t n = 0; n < rays.size(); ++n) {
                    CAPTURE(n);
                    CHECK(shots[n].hits == expected[n]);
                    CHECK((shots[n].answer == Shot::Answer::hit) == (expected[n] > 0));
                }
            }
        }
        CHECK(met > 100);
        CHECK(touched > 20);
        CHECK(inside > 100);
    }
}

// A sphere about (0, 0, 0) with the radius 5, and a ray along x, 3 from its centre, from x = −10: half the chord is 4,
// so it is met after 6, t = 3 for |D| = 2. A larger sphere about both does not count, nor does one that is touched.
TEST_CASE("proven, it finds the nearest of what it meets, with a bound on t") {
    Scene scene;
    scene.spheres = {{{0, 0, 0}, 5, {}}, {{0, 0, 0}, 100, {}}, {{-5, 0, 0}, 3, {}}, {{20, 0, 0}, 7, {}}};
    const Ray<double> ray{{-10, 3, 0}, {2, 0, 0}};
    for (const Scalar scalar : {Scalar::certified, Scalar::exact}) {
        const Shot shot = shoot(scene, published(scalar), {&ray, 1}).at(0);
        CHECK(shot.answer == Shot::Answer::hit);
        CHECK(shot.surface == 0);
        CHECK(shot.hits == 2);  // and the last, farther away
        CHECK(std::abs(static_cast<double>(shot.t) - 3) <= shot.t_error);
    }
}

// A ray 5/4 from the centre of a sphere of that radius touches it. One double nearer, it goes through: with Δ = r² − y²
// = 2⁻⁵² · 2.5, which is far below what 1e18, the squared distance, leaves of its digits in doubles.
TEST_CASE("proven, a hair tells a touch from a hit") {
    Scene scene;
    scene.spheres = {{{0, 0, 0}, 1.25, {}}};
    const auto met = [&](double y) {
        const Ray<double> ray{{-1e9, y, 0}, {1, 0, 0}};
        return shoot(scene, published(Scalar::certified), {&ray, 1}).at(0).answer == Shot::Answer::hit;
    };
    CHECK_FALSE(met(1.25));
    CHECK_FALSE(met(-1.25));
    CHECK(met(std::nextafter(1.25, 0)));
    CHECK_FALSE(met(std::nextafter(1.25, 2)));
}

// 32 rays of the paper's scene only touch a sphere: 50² is the sum of two squares of whole numbers in 20 ways, signs
// and order counted, and 20² in 12.
TEST_CASE("verdict: the truth is the mathematics' own, and a touch that is missed is a wrong miss") {
    const Scene scene = read_scene(SCENES "/levental-2014.toml");
    for (const Scalar scalar : {Scalar::certified, Scalar::double_}) {
        const auto counts = verdicts(scene, published(scalar));
        CHECK(counts[wrong_miss] == 32);
        CHECK(counts[right] == 250'000 - 32);
    }
}

TEST_CASE("verdict: from inside every ray meets the sphere, and by this rule none does") {
    Scene scene = read_scene(SCENES "/levental-2014.toml");
    scene.width = scene.height = 50;
    scene.spheres = {{{500, 25, 25}, 100, {}}};  // about all starts, (500, j, i)
    scene.triangles.clear();
    CHECK(verdicts(scene, published(Scalar::certified))[wrong_miss] == 2500);
    scene.spheres.push_back({{0, 25, 25}, 200, {}});  // each ray meets this one, too, behind the other's far side
    CHECK(verdicts(scene, published(Scalar::certified))[wrong_surface] == 2500);
}
