// Rays and scenes for which bounds are tight, or numbers extreme: each search must give the answer worked out here.
#include <doctest.h>

#include <cmath>
#include <optional>

#include "render/measure/reference_search.hpp"
#include "render/search/certified_search.hpp"
#include "render/search/exact_crossing.hpp"
#include "render/search/fast_search.hpp"

using namespace glassbox;

namespace {

struct Searched {
    std::optional<ProvenHit> plain, fast, all;  ///< `all`: as who wants all hits traces it
    std::optional<std::size_t> reference;
};

struct CountMet {
    static constexpr bool only_verdicts = true;
    int met = 0;

    template <class What, class... Values>
    void operator()(What, const Values&...) {
        met += std::is_same_v<What, told::Met>;
    }
};

Searched searched(const Surfaces<double>& surfaces, const Ray<double>& ray) {
    const auto engine = std::make_shared<const engine::Engine>(surfaces.spheres, surfaces.triangles, 1);
    const FastSearch fast(engine, {}, {});
    const CertifiedSearch plain(surfaces, {}, {}, including({}, ray), false);
    const Silent silent;
    CountMet met;
    Searched result{plain.trace_proven(ray, silent), fast.trace_proven(ray, silent), fast.trace_proven(ray, met), {}};
    result.reference = ReferenceSearch(engine).hits(ray).nearest;
    CHECK(fast.occluded(ray) == result.plain.has_value());
    return result;
}

void check_surface(const Searched& searched, std::optional<std::size_t> expected) {
    const auto number = [](const auto& hit) { return hit ? std::optional(hit->surface) : std::nullopt; };
    CHECK(number(searched.plain) == expected);
    CHECK(number(searched.fast) == expected);
    CHECK(number(searched.all) == expected);
    CHECK(searched.reference == expected);
}

}  // namespace

// The sphere's near root is 0, where the ray starts, and does not count: the sphere is met at t = 2, as is the
// triangle, which is listed last.
TEST_CASE("a ray that starts on a sphere, and a triangle at the sphere's far side") {
    const Surfaces<double> surfaces{{{{0, 0, 0}, 1}}, {{{1, -1, -1}, {1, 1, -1}, {1, 0, 1}}}};
    check_surface(searched(surfaces, {{-1, 0, 0}, {1, 0, 0}}), 1);
    // One bit nearer, and the triangle is the nearer.
    const double x = 1 - 0x1p-53;
    const Surfaces<double> nearer{{{{0, 0, 0}, 1}}, {{{x, -1, -1}, {x, 1, -1}, {x, 0, 1}}}};
    check_surface(searched(nearer, {{-1, 0, 0}, {1, 0, 0}}), 1);
}

// P + 2⁶⁰ D = (0, 0, 0), inside the triangle in the plane y = 0.
TEST_CASE("a ray from 2⁶⁰ away that drifts by 2⁻⁶⁰") {
    const Surfaces<double> surfaces{{}, {{{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}}}};
    check_surface(searched(surfaces, {{-0x1p60, -1, 0}, {1, 0x1p-60, 0}}), 0);
}

// Most surfaces lie at 1e60; the ray along x meets the sphere about the origin at x = −1, t = 2.
TEST_CASE("most surfaces farther away than floats can say") {
    const Surfaces<double> surfaces{
        {{{1e60, 0, 0}, 1}, {{1e60, 3, 0}, 1}, {{1e60, 6, 0}, 1}, {{0, 0, 0}, 1}, {{0, 5, 0}, 1}}, {}};
    const Searched found = searched(surfaces, {{-3, 0, 0}, {1, 0, 0}});
    check_surface(found, 3);
    CHECK(found.fast->told_t == 2);
    check_surface(searched(surfaces, {{-3, -2, 0}, {1, 0, 0}}), std::nullopt);
    // At y = 2 the ray touches the far sphere whose centre is at y = 3.
    check_surface(searched(surfaces, {{-3, 2, 0}, {1, 0, 0}}), 1);
}

// From inside a tiny sphere, t with r = 2⁻⁴⁸⁰, P = (r/2, 0, 0), D = 2⁻⁸⁹ (−1, 1, 0): |P + tD|² = r² is 2s² − s + 1/4 =
// 1 with s = t 2⁻⁸⁹/r, so s = (1 + √7)/4.
TEST_CASE("t of a sphere whose squares underflow is told with all its digits, and the same by all") {
    const double r = 0x1p-480;
    const Surfaces<double> surfaces{{{{0, 0, 0}, r}}, {}};
    const Searched found = searched(surfaces, {{r / 2, 0, 0}, {-0x1p-89, 0x1p-89, 0}});
    check_surface(found, 0);
    const double expected = (1 + std::sqrt(7.0)) / 4 * 0x1p-391;
    CHECK(std::abs(found.fast->told_t - expected) <= 0x1p-50 * expected);
    CHECK(found.fast->told_t == found.plain->told_t);
}

TEST_CASE("a ray from the only point of a triangle without extent") {
    const Surfaces<double> surfaces{{}, {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}};
    check_surface(searched(surfaces, {{0, 0, 0}, {1, 0, 0}}), std::nullopt);
}

// From so far off the engine, which looks from near the triangle, is sure that it is met where plain double's side
// products are nothing but rounding; their t was off by 0.8. The triangle lies within √3 of the world's origin, and so
// does what the ray meets of it: by |P|/|D| = 2²⁴, t is within 1 of it, and the search must tell it as it does when it
// is asked of the surface alone.
TEST_CASE("t of a triangle that is met from far off is told the same whoever finds it") {
    Surfaces<double> surfaces;
    const Triangle<double> triangle{{-0x1.f61ca590aab66p-1, -0x1.321b0536a4d59p-1, 0x1.8bc69b8ee8b16p-1},
                                    {0x1.983dfdad6726cp-1, 0x1.b1ec8b7faeda4p-1, -0x1.18e94c15fad2cp-1},
                                    {0x1.1f79616b07214p-1, 0x1.53eba9c6b5d84p-2, -0x1.bac56ae82b554p-3}};
    surfaces.triangles.push_back(triangle);
    for (int i = 1; i < 20; ++i) {
        const Vec3<double> shift{0, 1000.0 * i, 0};
        surfaces.triangles.push_back({triangle.A + shift, triangle.B + shift, triangle.C + shift});
    }
    surfaces.triangles.push_back({{0x1p22, 0, 0x1p22}, {0x1p22, 0x1p22, 0x1p22}, {0x1p22, 0, 0x1p23}});
    const Ray<double> ray{{-0x1.800000f3c5029p+24, -0x1.27cb2d61c3f8bp+24, 0x1.e37b65d14c4b4p+23},
                          {0x1.8p+0, 0x1.27cb2cce726fcp+0, -0x1.e37b64502bd49p-1}};
    const Searched found = searched(surfaces, ray);
    check_surface(found, 0);
    const TrueT t = *exact_crossing(ray, triangle, Pluecker{});
    CHECK(std::abs(t.to_bounded().value - 0x1p24) < 1);
    CHECK(found.fast->told_t == found.plain->told_t);
    CHECK(std::abs(found.fast->told_t - t.to_bounded().value) <= 0x1p-28);
}

// At the scene's own scale the products of z underflow, and at the engine's they do not: by either the normal is
// rounded in its last digit, but it must be the same, or a picture's bytes would tell whether the engine was used.
TEST_CASE("the normal of a triangle with subnormal coordinates is the same by every search") {
    Surfaces<double> surfaces;
    surfaces.triangles.push_back(
        {{0, 0, 0}, {0, 1.044048714879764e-53, 4.243991582e-314}, {-4.176194859519056e-53, -1.044048714879764e-53, 0}});
    const Ray<double> ray{{-1.6704779438076223e-52, 0, 0}, {1, 0, 0}};
    const auto engine = std::make_shared<const engine::Engine>(surfaces.spheres, surfaces.triangles, 1);
    REQUIRE(engine->scale() != 1);
    const CertifiedSearch plain(surfaces, {}, {}, including({}, ray), false);
    const Hit<double> hit{0, 1.6704779438076223e-52};
    CHECK(FastSearch(engine, {}, {}).normal_at(ray, hit) == plain.normal_at(ray, hit));
}
