// Spheres so far off that doubles lose most of their digits: where they are met, and their normals there, against exact
// arithmetic.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "bounds_against_exact.hpp"
#include "render/search/exact_crossing.hpp"
#include "render/search/surface_normal.hpp"

using namespace glassbox;

namespace {

/// The normal by exact arithmetic alone: each coordinate of the point as seen from the centre, in units of about the
/// radius, is rounded once.
std::optional<Vec3<double>> true_normal(const Ray<double>& ray, const Sphere<double>& sphere) {
    const std::optional<TrueT> t = exact_crossing(ray, sphere, Stable{});
    if (!t) return {};
    const Exact unit(std::ldexp(1.0, std::clamp(-std::ilogb(sphere.r), -1000, 1000)));
    const Vec3<Exact> point = unit * (at(convert<Exact>(ray), t->exact()) - convert<Exact>(sphere.C));
    const auto rounded = [](const Exact& x) { return x.to_bounded().value; };
    return unit_normal(Sphere<double>{{}, 1}, {rounded(point.x), rounded(point.y), rounded(point.z)});
}

struct NormalCounts {
    int met = 0, missed = 0, wrong = 0;
};

/// A sphere at that distance in radii, and a ray at a point in it, on its rim, or beside it.
void check_normal(NormalCounts& counts, double radius, double distance, double speed, test::Doubles& random) {
    const Vec3<double> away = test::some_vector(random, 1);
    if (length(away) == 0) return;
    const Vec3<double> start = test::some_vector(random, random.one_in(2) ? radius : radius * distance);
    const Sphere<double> sphere{start + radius * distance / length(away) * away, radius};
    const Vec3<double> aside = unit(cross(away, test::some_vector(random, 1)));
    const double by = random.one_in(3) ? 1 : 1.2 * random.fraction();
    const Ray<double> ray{
        start, (random.one_in(10) ? -speed : speed) / distance * (1 / radius * (sphere.C - start) + by * aside)};
    if (!is_valid(ray) || !is_finite(sphere.C) || !is_far_off(ray, sphere)) return;
    const std::optional<Vec3<double>> normal = exact_normal(ray, sphere, Stable{}), truth = true_normal(ray, sphere);
    ++(truth ? counts.met : counts.missed);
    counts.wrong += normal != truth;
}

}  // namespace

TEST_CASE("normals of spheres far off are as true as exact arithmetic's, bit for bit") {
    test::Doubles random(51);
    NormalCounts counts;
    for (int i = 0; i < 3000; ++i)
        check_normal(counts, test::power_of_ten(random, -5, 5), random.positive(30, 60),
                     test::power_of_ten(random, -5, 5), random);
    CHECK(counts.wrong == 0);
    CHECK(counts.met > 1000);
    CHECK(counts.missed > 300);
}

TEST_CASE("normals of spheres far off at any magnitude, where products overflow or underflow") {
    test::Doubles random(52);
    NormalCounts counts;
    for (int i = 0; i < 2000; ++i)
        check_normal(counts, test::magnitude(random), random.positive(30, random.one_in(2) ? 40 : 400),
                     test::magnitude(random), random);
    CHECK(counts.wrong == 0);
    CHECK(counts.met > 300);
}
