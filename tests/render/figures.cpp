// The paper's five figures: our picture and that of the paper's own program, rewritten from its description, are equal
// in every pixel.
#include <doctest.h>

#include <baseline.hpp>
#include <cstddef>
#include <vector>

#include "render/render.hpp"
#include "scene/scene_file.hpp"

using namespace glassbox;

namespace {

struct Figure {
    const char* name;
    double k_a, k_d, k_s;
};

constexpr Figure figures[] = {{"only ambient", 1, 0, 0},
                              {"only diffuse", 0, 1, 0},
                              {"only specular", 0, 0, 1},
                              {"specular and diffuse", 0, 1, .2},
                              {"final", .2, 1, .2}};

std::size_t different_pixels(const Image& image, const std::vector<unsigned char>& expected) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        if (image.pixels[i] != Rgb{expected[3 * i], expected[3 * i + 1], expected[3 * i + 2]}) ++different;
    return different;
}

}  // namespace

TEST_CASE("the five figures equal the paper's in every one of 250,000 pixels") {
    Scene scene = read_scene(SCENES "/levental-2014.toml");
    for (const Figure& figure : figures) {
        CAPTURE(figure.name);
        scene.shading.k_a = figure.k_a;
        scene.shading.k_d = figure.k_d;
        scene.shading.k_s = figure.k_s;
        CHECK(different_pixels(render(scene, {}), render_as_published(500, 500, figure.k_a, figure.k_d, figure.k_s)) ==
              0);
    }
}

TEST_CASE("whatever the rules, the figure \"final\" is the paper's") {
    const Scene scene = read_scene(SCENES "/levental-2014.toml");
    const std::vector<unsigned char> expected = render_as_published(500, 500, .2, 1, .2);
    const SphereRule sphere_rules[] = {Stable{}, Textbook{}};
    const TriangleRule triangle_rules[] = {Pluecker{}, Tolerance{}, MoellerTrumbore{}};
    for (const SphereRule& sphere_rule : sphere_rules)
        for (const TriangleRule& triangle_rule : triangle_rules) {
            CAPTURE(sphere_rule.index());
            CAPTURE(triangle_rule.index());
            Options options;
            options.sphere_rule = sphere_rule;
            options.triangle_rule = triangle_rule;
            CHECK(different_pixels(render(scene, options), expected) == 0);
        }
}

TEST_CASE("the stages: each adds its own to the picture") {
    Scene scene = read_scene(SCENES "/levental-2014.toml");
    scene.border.reset();
    const auto pixel = [&](int stage, int column, int row) {
        Options options;
        options.stage = stage;
        return render(scene, options).at(column, 499 - row);
    };
    // 1: every ray runs along (-1,0,0): red 255/2·(1 − 1) = 0, green and blue 255/2 = 127.5, which rounds to 128; on
    // every second square of 50 pixels 204/2 = 102.
    CHECK(pixel(1, 350, 350) == Rgb{0, 128, 128});
    CHECK(pixel(1, 350, 300) == Rgb{0, 102, 102});
    // 2: the spheres' own colours, and no triangle.
    CHECK(pixel(2, 350, 350) == Rgb{0, 255, 0});
    CHECK(pixel(2, 300, 300) == Rgb{255, 0, 0});
    CHECK(pixel(2, 375, 120) == Rgb{0, 0, 0});
    // 3: triangles, too.
    CHECK(pixel(3, 350, 350) == Rgb{0, 255, 0});
    CHECK(pixel(3, 375, 120) == Rgb{128, 128, 128});
    // 4: shaded, as in the figure "final"; stage 5 without turns is the same.
    CHECK(pixel(4, 375, 120) == pixel(5, 375, 120));
    CHECK(pixel(4, 375, 120) != Rgb{128, 128, 128});
}

TEST_CASE("float and long double draw the paper's picture, too") {
    // All its coordinates are whole numbers under 2^12, so the side products (products of three) are exact in double
    // and long double: which surface is hit is the same to the last pixel. In float the terms reach 2^29, beyond its
    // 2^24.
    Scene scene = read_scene(SCENES "/levental-2014.toml");
    Options flat;
    flat.stage = 3;
    const Image expected = render(scene, flat);
    flat.scalar = Scalar::long_double;
    CHECK(render(scene, flat).pixels == expected.pixels);
    flat.scalar = Scalar::float_;
    const Image in_float = render(scene, flat);
    std::size_t different = 0;
    for (std::size_t i = 0; i < expected.pixels.size(); ++i)
        if (in_float.pixels[i] != expected.pixels[i]) ++different;
    CHECK(different < 300);  // only where a surface ends: their outlines are about 600 pixels long
}
