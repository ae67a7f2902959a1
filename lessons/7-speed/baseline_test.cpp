// What the paper says of its pictures, and what its formulas give by hand at a few pixels.
#include <doctest.h>
#include <baseline.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace {

using Color = std::array<int, 3>;
constexpr int side = 404;  // the paper has 500; all surfaces lie within these

/// The pixel of column j, to the right, and row i, upwards.
Color pixel(const std::vector<unsigned char>& picture, int j, int i) {
    const auto at = 3 * static_cast<std::size_t>((side - 1 - i) * side + j);
    return {picture[at], picture[at + 1], picture[at + 2]};
}

const Color black{0, 0, 0}, red{255, 0, 0};

}  // namespace

TEST_CASE("ambient light is one warm colour on every surface") {
    const auto picture = glassbox::render_as_published(side, side, 1, 0, 0);
    const Color warm{255, 102, 102};
    CHECK(pixel(picture, 350, 350) == warm);
    CHECK(pixel(picture, 300, 300) == warm);
    CHECK(pixel(picture, 375, 120) == warm);
}

TEST_CASE("diffuse light: the surface's colour times n.l, cut to whole bytes") {
    const auto picture = glassbox::render_as_published(side, side, 0, 1, 0);
    // In the middle of a sphere n = (1,0,0), and n.l = 1000 / |(1000,250,250)| = 0.94281: 0.94281 * 255 = 240.4.
    CHECK(pixel(picture, 350, 350) == Color{0, 240, 0});
    CHECK(pixel(picture, 300, 300) == Color{240, 0, 0});
    // One below the green one's top n = (sqrt 99, 0, 49) / 50, as 99 + 49^2 = 50^2, and n.l = (4 sqrt 99 + 49) /
    // (50 sqrt 18) = 0.41860: 106.7. The ray of the top only touches the sphere, and misses it.
    CHECK(pixel(picture, 350, 399) == Color{0, 106, 0});
    CHECK(pixel(picture, 350, 400) == black);
    // PSR has n = (1,-2,1)/sqrt(6), n.l = 0.28868, times 128 = 36.95; QRS has (1,2,1)/sqrt(6), 0.67358, 86.2.
    CHECK(pixel(picture, 365, 110) == Color{36, 36, 36});
    CHECK(pixel(picture, 385, 110) == Color{86, 86, 86});
    // Both meet in the edge RS, at equal distance: the one listed last is seen.
    CHECK(pixel(picture, 375, 120) == Color{86, 86, 86});
}

TEST_CASE("all light: three terms, each cut to whole bytes, held at 255, on black, in a red border one pixel wide") {
    const auto picture = glassbox::render_as_published(side, side, .2, 1, .2);
    REQUIRE(picture.size() == 3 * side * side);
    CHECK(glassbox::rays_as_published(side, side) == side * side);
    // Ambient (51, 20, 20), diffuse (0, 240, 0); n.h = 1001 / |(1001,250,250)| = 0.94291, to the 15th 0.4141, times 51
    // is 21.1. The sum (72, 281, 41) has too much green.
    CHECK(pixel(picture, 350, 350) == Color{72, 255, 41});
    CHECK(pixel(picture, 1, 1) == black);
    CHECK(pixel(picture, side - 2, side - 2) == black);
    CHECK(pixel(picture, 250, 250) == black);
    for (int k = 0; k < side; ++k) {
        CHECK(pixel(picture, k, 0) == red);
        CHECK(pixel(picture, k, side - 1) == red);
        CHECK(pixel(picture, 0, k) == red);
        CHECK(pixel(picture, side - 1, k) == red);
    }
}
