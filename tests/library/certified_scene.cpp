// The library's answers: what is first, what is met in which order, and bounds that hold.
#include "library/certified_scene.hpp"

#include <doctest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

using namespace glassbox;

namespace {

const std::vector<Triangle<double>> two_squares(double z) {
    return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}},
            {{0, 0, 0}, {1, 1, 0}, {0, 1, 0}},
            {{0, 0, -z}, {1, 0, -z}, {1, 1, -z}},
            {{0, 0, -z}, {1, 1, -z}, {0, 1, -z}}};
}

template <class Call>
std::string complaint(const Call& call) {
    try {
        call();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("the first hit, and all in order, on an edge and a hair's breadth apart") {
    // Through the diagonal, which belongs to both triangles: at equal t the one listed last comes first. The second
    // square lies 2⁻⁶⁰ behind the first, far below what doubles at t = 2²⁰ tell apart.
    const CertifiedScene scene({}, two_squares(0x1p-60));
    const Ray<double> ray{{0.5, 0.5, 0x1p20}, {0, 0, -1}};
    REQUIRE(scene.first_hit(ray));
    CHECK(scene.first_hit(ray)->surface == 1);
    const std::vector<CertifiedHit> hits = scene.all_hits(ray);
    REQUIRE(hits.size() == 4);
    const std::size_t order[] = {1, 0, 3, 2};
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(hits[i].surface == order[i]);
        CHECK(std::abs(hits[i].t - 0x1p20) <= hits[i].t_error + 0x1p-60);
        CHECK(hits[i].t_error <= 0x1p-30);
    }
    CHECK_FALSE(scene.first_hit({{2, 2, 1}, {0, 0, -1}}));
    CHECK(scene.all_hits({{0.5, 0.5, -1}, {0, 0, -1}}).empty());  // all behind
}

TEST_CASE("t lies within its bound: thirds, and roots") {
    // From (0, 0, 5) along (0, 0, −3) the unit sphere is met at z = 1: t = 4/3. Along (1, 0, 3) from (0, 0, −5), with
    // v·D = −15 and D² = 10, t = (15 − √(225 − 240))/10 misses; along (1, 0, 8): v·D = −40, D² = 65, Δ = 1600 − 1560 =
    // 40, t = (40 − √40)/65.
    const CertifiedScene scene({{{0, 0, 0}, 1}}, {});
    const auto down = scene.first_hit({{0, 0, 5}, {0, 0, -3}});
    REQUIRE(down);
    CHECK(std::abs(static_cast<long double>(down->t) - 4 / 3.0L) <= down->t_error);
    CHECK_FALSE(scene.first_hit({{0, 0, -5}, {1, 0, 3}}));
    const auto aslant = scene.first_hit({{0, 0, -5}, {1, 0, 8}});
    REQUIRE(aslant);
    CHECK(std::abs(static_cast<long double>(aslant->t) - (40 - std::sqrt(40.0L)) / 65) <= aslant->t_error + 1e-18L);
    CHECK(aslant->t_error <= 1e-15);
}

TEST_CASE("spheres are numbered first, and bad numbers are refused by their surface") {
    const CertifiedScene scene({{{5, 0, 0}, 1}}, two_squares(1));
    CHECK(scene.size() == 5);
    CHECK(scene.first_hit({{0.75, 0.25, 1}, {0, 0, -1}})->surface == 1);
    const double inf = std::numeric_limits<double>::infinity();
    CHECK(complaint([&] { CertifiedScene({{{0, 0, 0}, 1}, {{0, 0, 0}, 0}}, {}); }).find("sphere 1") == 0);
    const std::vector<Triangle<double>> bad{{{0, 0, inf}, {1, 0, 0}, {0, 1, 0}}};
    CHECK(complaint([&] { CertifiedScene({}, bad); }).find("triangle 0") == 0);
    CHECK(complaint([&] { scene.first_hit({{0, 0, 0}, {0, 0, 0}}); }).find("a ray must have") == 0);
    CHECK(complaint([&] { scene.all_hits({{inf, 0, 0}, {0, 0, 1}}); }).find("a ray must have") == 0);
}

TEST_CASE("a scene without surfaces answers, too") {
    const CertifiedScene none({}, {});
    CHECK(none.size() == 0);
    CHECK_FALSE(none.first_hit({{0, 0, 0}, {0, 0, 1}}));
}
