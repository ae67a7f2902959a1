// Light beyond all ranges: a pixel is as bright as a byte allows, and never black because of a NaN.
#include <doctest.h>

#include <array>
#include <cmath>
#include <limits>

#include "render/lighting.hpp"
#include "render/render.hpp"

using namespace glassbox;

namespace {

constexpr std::array models{ShadingModel::phong, ShadingModel::blinn_phong, ShadingModel::levental_2014};
constexpr std::array every_scalar{Scalar::certified, Scalar::float_, Scalar::double_, Scalar::long_double,
                                  Scalar::exact};

/// The middle of a ball of that colour, seen and lit from straight before it: n = l = r = h = (1, 0, 0), so that every
/// cosine is 1, in every scalar and model.
Scene ball(Rgb color) {
    Scene scene;
    scene.width = scene.height = 1;
    scene.view = ParallelView{{10, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}};
    scene.light_vector = {1, 0, 0};
    scene.spheres = {{{0, 0, 0}, 1, color}};
    return scene;
}

Rgb pixel(const Scene& scene, ShadingModel model, Scalar scalar) {
    Scene shaded = scene;
    shaded.shading.model = model;
    Options options;
    options.scalar = scalar;
    return render(shaded, options).at(0, 0);
}

void check_everywhere(const Scene& scene, Rgb expected) {
    for (const ShadingModel model : models)
        for (const Scalar scalar : every_scalar) {
            CAPTURE(static_cast<int>(model));
            CAPTURE(static_cast<int>(scalar));
            CHECK((pixel(scene, model, scalar) == expected));
        }
}

}  // namespace

TEST_CASE("a term that overflows is white with a white highlight, and the surface's colour without") {
    // diffuse 1e308·10·1 × (0, 255, 0) has no red and no blue; specular 1e308·0.2·1 × (255, 255, 255) has all.
    Scene scene = ball({0, 255, 0});
    scene.light_intensity = 1e308;
    scene.shading.k_d = 10;
    check_everywhere(scene, {255, 255, 255});
    scene.shading.k_a = scene.shading.k_s = 0;
    check_everywhere(scene, {0, 255, 0});
}

TEST_CASE("ambient light beyond the scalar's range keeps its colour") {
    Scene scene = ball({0, 255, 0});
    scene.shading.k_d = scene.shading.k_s = 0;
    scene.shading.ambient_color = {255, 0, 102};
    for (const double k_a : {1e39, 1.7e308}) {  // beyond a float; near the end of a double, and beyond it times 255
        scene.shading.k_a = k_a;
        check_everywhere(scene, {255, 0, 255});
    }
}

TEST_CASE("no light falls on what is turned away from it, however bright") {
    Scene scene = ball({0, 255, 0});
    scene.light_vector = {-1, 0, 0};  // behind the ball: n·l = -1, and n·h or r·m is not above 0
    scene.light_intensity = 1.7e308;
    scene.shading.k_d = scene.shading.k_s = 1.7e308;
    scene.shading.k_a = 0.2;
    check_everywhere(scene, {51, 20, 20});  // 0.2 · (255, 102, 102) = (51, 20.4, 20.4)
}

TEST_CASE("no light is no light, whatever the factors") {
    Scene scene = ball({0, 255, 0});
    scene.light_intensity = 0;
    scene.shading.k_d = scene.shading.k_s = 1.7e308;
    scene.shading.k_a = 0.2;
    check_everywhere(scene, {51, 20, 20});
}

TEST_CASE_TEMPLATE(
    "the largest exponent leaves a highlight's middle only, and no infinity where a cosine was rounded up", Real, float,
    double, long double) {
    Scene scene;
    scene.shading.exponent = 1.7e308;
    const auto e = static_cast<Real>(lighting<Real>(scene).shading.exponent);
    const Real ulp = std::numeric_limits<Real>::epsilon();
    // With u = ulp/2 = 2^-p and e = 2^(p+3): (1 - u)^e = exp(-8) = 0.0003, and 255 of it round to 0.
    CHECK(255 * std::pow(1 - ulp / 2, e) < Real(0.5));
    // (1 + 4 ulp)^e = exp(64) = 6e27.
    CHECK(std::isfinite(std::pow(1 + 4 * ulp, e)));
}

TEST_CASE("of the light's position only the direction counts, in float, too") {
    Scene scene = ball({0, 200, 0});
    scene.shading.k_a = scene.shading.k_s = 0;
    // n·l = 3/sqrt(9 + 1 + 4) = 0.8018, times 200: 160.4
    for (const double size : {1e-150, 1e-30, 1e-19, 1., 1e19, 1e30, 1e149}) {
        scene.light_vector = {3 * size, size, 2 * size};
        check_everywhere(scene, {0, 160, 0});
    }
}
