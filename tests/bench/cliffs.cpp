// The cliffs: each is as large as what it is compared with. How long they take is for `glassbox bench --cliffs`.
#include <doctest.h>

#include "bench/cliffs/cliff.hpp"
#include "bench/cliffs/timed.hpp"
#include "render/pixel.hpp"
#include "render/search/surfaces.hpp"

using namespace glassbox;

namespace {

std::size_t rays(const Traced& traced) {
    return traced.rays.empty() ? pixel_count(traced.scene.width, traced.scene.height) : traced.rays.size();
}

double surfaces_of(const Traced& traced) {
    const auto [spheres, triangles] = count_surfaces(traced.scene, 5);
    return static_cast<double>(spheres + triangles);
}

}  // namespace

TEST_CASE("a cliff has as many rays and surfaces as the ordinary scene beside it") {
    for (const Cliff& cliff : all_cliffs()) {
        CAPTURE(cliff.name);
        const Traced traced = cliff.make(16), ordinary = cliff.make_ordinary(16);
        CHECK(rays(traced) == 16 * 16);
        CHECK(rays(ordinary) == 16 * 16);
        // hills of about a thousand triangles are 22 · 22 · 2 = 968
        CHECK(surfaces_of(traced) / surfaces_of(ordinary) == doctest::Approx(1).epsilon(0.04));
        CHECK(cliff.goal > 1);
        for (const Ray<double>& ray : traced.rays) REQUIRE(is_valid(ray));
    }
}

TEST_CASE("a cliff is timed in turn with the other, and its answers checked") {
    for (const Cliff& cliff : all_cliffs())
        if (cliff.name == "one sphere of radius 1, and the eye, at 1e6" || cliff.name == "a surface of 2^51") {
            const CliffTimes times = time_cliff(cliff, 2, 300, {});
            CHECK(times.rays >= 64);
            CHECK(times.ordinary.size() == times.this_one.size());
            for (const double nanoseconds : times.this_one) CHECK(nanoseconds > 0);
            CHECK(times.checked == 300);
            CHECK(times.wrong == 0);
        }
}
