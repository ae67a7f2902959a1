// The paper's five figures: with its program's sphere rule, our picture equals that of the program, rewritten from its
// description, in every pixel; with the other rules the pixels differ whose rays only touch a sphere.
#include <doctest.h>

#include <baseline.hpp>
#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "render/option_names.hpp"
#include "render/render.hpp"
#include "scene/scene_file.hpp"

using namespace glassbox;

namespace {

/// In `touched` of its pixels one sees only the point of a sphere that the ray touches, and it is not black; the
/// paper's program misses these.
struct Figure {
    const char* name;
    double k_a, k_d, k_s;
    std::size_t touched;
};

// The ray of column j and row i passes at √((j − y)² + (i − z)²) from the centre of a sphere about (x, y, z). That is
// the radius where two squares of integers add up to its square: 50² = 0² + 50² = 30² + 40² = 14² + 48² has 4 + 8 + 8
// points, (±50, 0), (0, ±50), (±30, ±40) and so on; 20² = 0² + 20² = 12² + 16² has 4 + 8. That makes 32, all on black:
// the red sphere's point that is nearest to the green one's centre, (300 + 16, 300 + 12), is √(34² + 38²) = 51 from it,
// and the green one's to the red one's, (350 − 40, 350 − 30), is 22.
//
// Ambient light falls on all 32. At a touch n = (0, j − y, i − z)/r, and n·l = (j − y + i − z)/(r √18): above 0 where
// that sum is, which is half of them, 16, as no sum is 0. The least, of 40 − 30 and of 16 − 12, makes (1/5)/√18 · 255 =
// 12, not black. The highlight, at most (70/(50 √18))¹⁵ · 255 = 1.6e−5 (h is nearly l), is cut to 0.
constexpr Figure figures[] = {{"only ambient", 1, 0, 0, 32},
                              {"only diffuse", 0, 1, 0, 16},
                              {"only specular", 0, 0, 1, 0},
                              {"specular and diffuse", 0, 1, .2, 16},
                              {"final", .2, 1, .2, 32}};

Scene drawn_as(const Figure& figure) {
    Scene scene = read_scene(SCENES "/levental-2014.toml");
    scene.shading.k_a = figure.k_a;
    scene.shading.k_d = figure.k_d;
    scene.shading.k_s = figure.k_s;
    return scene;
}

/// Drawn once: the paper's program takes its time.
const std::vector<unsigned char>& published(const Figure& figure) {
    static std::map<const Figure*, std::vector<unsigned char>> drawn;
    std::vector<unsigned char>& picture = drawn[&figure];
    if (picture.empty()) picture = render_as_published(500, 500, figure.k_a, figure.k_d, figure.k_s);
    return picture;
}

Options by(const SphereRule& rule, Scalar scalar = Scalar::certified) {
    Options options;
    options.sphere_rule = rule;
    options.scalar = scalar;
    return options;
}

std::size_t different_pixels(const Image& image, const std::vector<unsigned char>& expected) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        if (image.pixels[i] != Rgb{expected[3 * i], expected[3 * i + 1], expected[3 * i + 2]}) ++different;
    return different;
}

/// Whether the ray of that pixel touches one of the two spheres.
bool touches(int x, int y) {
    const auto beside = [&](int middle) {
        return (x - middle) * (x - middle) + (499 - y - middle) * (499 - y - middle);
    };
    return beside(350) == 50 * 50 || beside(300) == 20 * 20;
}

// Checked code is slow: under the sanitizers only the last figure is drawn.
std::span<const Figure> drawn_figures() {
#ifdef GLASSBOX_SANITIZED
    return std::span(figures).last(1);
#else
    return figures;
#endif
}

}  // namespace

TEST_CASE("by its own sphere rule the five figures equal the paper's in every one of 250,000 pixels") {
    for (const Figure& figure : drawn_figures()) {
        CAPTURE(figure.name);
        CHECK(different_pixels(render(drawn_as(figure), by(Levental2014{})), published(figure)) == 0);
    }
}

TEST_CASE("by the others they differ where a ray only touches a sphere, and nowhere else") {
    for (const Figure& figure : drawn_figures())
        for (const SphereRule& rule : {SphereRule(Stable{}), SphereRule(Textbook{})}) {
            CAPTURE(figure.name);
            CAPTURE(name_of(rule));
            CHECK(different_pixels(render(drawn_as(figure), by(rule)), published(figure)) == figure.touched);
        }
    const Figure& final_one = figures[4];
    const Image true_one = render(drawn_as(final_one), {}),
                as_published = render(drawn_as(final_one), by(Levental2014{}));
    for (int y = 0; y < 500; ++y)
        for (int x = 0; x < 500; ++x) {
            const bool same = true_one.at(x, y) == as_published.at(x, y);
            if (same != touches(x, y)) continue;
            CAPTURE(x);
            CAPTURE(y);
            FAIL_CHECK("equal where a ray touches, or different where none does");
        }
}

TEST_CASE("in each scalar, and by each triangle rule, the figure \"final\" is the paper's") {
    const Figure& final_one = figures[4];
    const Scene scene = drawn_as(final_one);
    const std::vector<unsigned char> expected = published(final_one);
    for (const TriangleRule& triangle_rule :
         {TriangleRule(Pluecker{}), TriangleRule(Tolerance{}), TriangleRule(MoellerTrumbore{})})
        for (const Scalar scalar : {Scalar::certified, Scalar::double_}) {
            CAPTURE(name_of(triangle_rule));
            CAPTURE(name_of(scalar));
            Options options = by(Levental2014{}, scalar);
            options.triangle_rule = triangle_rule;
            CHECK(different_pixels(render(scene, options), expected) == 0);
        }
}

TEST_CASE("that rule has only the plain loop: the engine is not asked, nor does it change a pixel") {
    const Scene scene = drawn_as(figures[4]);
    Options options = by(Levental2014{});
    const Image plain = render(scene, options);
    options.engine = EngineChoice::fast;
    CHECK(render(scene, options).pixels == plain.pixels);
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
