#include "output/color_map.hpp"

#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "output/oklab.hpp"

using namespace glassbox;

namespace {

/// How a colour looks to someone without one kind of cone: Machado, Oliveira and Fernandes, "A Physiologically-based
/// Model for Simulation of Color Vision Deficiency" (2009), severity 1; a matrix on light, not on bytes.
using Matrix = double[3][3];
constexpr Matrix protanopia = {
    {0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}};
constexpr Matrix deuteranopia = {
    {0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}};

double to_light(int byte) {
    const double v = byte / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

std::uint8_t to_byte(double light) {
    return rounded_byte(255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055));
}

Rgb seen_with(const Matrix& m, const Rgb& color) {
    const double r = to_light(color.red), g = to_light(color.green), b = to_light(color.blue);
    const auto row = [&](int i) { return to_byte(m[i][0] * r + m[i][1] * g + m[i][2] * b); };
    return {row(0), row(1), row(2)};
}

/// The map's colours at 33 positions.
std::vector<Rgb> samples(const ColorMap& map) {
    std::vector<Rgb> colors;
    for (int i = 0; i <= 32; ++i) colors.push_back(map(i / 32.0));
    return colors;
}

std::vector<double> steps(const std::vector<Rgb>& colors) {
    std::vector<double> all;
    for (std::size_t i = 1; i < colors.size(); ++i)
        all.push_back(difference(to_oklab(colors[i - 1]), to_oklab(colors[i])));
    return all;
}

double least(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }
double greatest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

double distance_from(const std::vector<Rgb>& colors, const Rgb& color) {
    std::vector<double> all;
    for (const Rgb& c : colors) all.push_back(difference(to_oklab(c), to_oklab(color)));
    return least(all);
}

}  // namespace

TEST_CASE("OKLab has the values that its author gives") {
    // White is L = 1 without a or b; sRGB's red is (0.6280, 0.2249, 0.1258), from Ottosson's matrices by hand.
    const OkLab white = to_oklab({255, 255, 255});
    CHECK(white.lightness == doctest::Approx(1).epsilon(1e-6));
    CHECK(std::hypot(white.a, white.b) < 1e-6);
    const OkLab red = to_oklab({255, 0, 0});
    CHECK(red.lightness == doctest::Approx(0.6280).epsilon(1e-3));
    CHECK(red.a == doctest::Approx(0.2249).epsilon(1e-3));
    CHECK(red.b == doctest::Approx(0.1258).epsilon(1e-3));
    for (const Rgb color : {Rgb{0, 0, 0}, Rgb{1, 2, 3}, Rgb{200, 100, 50}, Rgb{255, 255, 0}})
        CHECK(to_rgb(to_oklab(color)) == color);
}

TEST_CASE("sequential: from dark blue to bright yellow, lighter all the way") {
    const std::vector<Rgb> colors = samples(sequential_colors());
    CHECK(colors.front().blue > 2 * colors.front().red);
    CHECK(std::min(colors.back().red, colors.back().green) > 2 * colors.back().blue);
    for (std::size_t i = 1; i < colors.size(); ++i)
        CHECK(to_oklab(colors[i]).lightness > to_oklab(colors[i - 1]).lightness);
    for (const Rgb& color : colors) CHECK(std::hypot(to_oklab(color).a, to_oklab(color).b) > 0.08);  // never near grey
}

TEST_CASE("danger: from dark to bright, lighter all the way, for colour-blind readers, too") {
    for (const Matrix* matrix : {static_cast<const Matrix*>(nullptr), &protanopia, &deuteranopia}) {
        std::vector<Rgb> colors = samples(danger_colors());
        if (matrix)
            for (Rgb& color : colors) color = seen_with(*matrix, color);
        for (std::size_t i = 1; i < colors.size(); ++i)
            CHECK(to_oklab(colors[i]).lightness > to_oklab(colors[i - 1]).lightness);
        CHECK(to_oklab(colors.front()).lightness < 0.35);
        CHECK(to_oklab(colors.back()).lightness > 0.9);
        for (const Rgb color : {no_value_color, danger_infinity_color, danger_minus_infinity_color})
            CHECK(distance_from(colors, matrix ? seen_with(*matrix, color) : color) > 0.09);
    }
}

TEST_CASE("words are told apart by colour-blind readers, and what is right is far darker") {
    for (const Matrix* matrix : {&protanopia, &deuteranopia}) {
        std::vector<Rgb> colors;
        for (int i = 0; i < 4; ++i) colors.push_back(seen_with(*matrix, word_colors(4)(i / 3.0)));
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < i; ++j) CHECK(difference(to_oklab(colors[i]), to_oklab(colors[j])) > 0.1);
    }
}

TEST_CASE("diverging: as dark on either side, lightest in the middle") {
    const std::vector<Rgb> colors = samples(diverging_colors());
    CHECK(colors.front().blue > colors.front().red);
    CHECK(colors.back().red > colors.back().blue);
    CHECK(to_oklab(colors[16]).lightness > 0.95);
    for (std::size_t i = 0; i < 16; ++i) {
        const double left = to_oklab(colors[i]).lightness, right = to_oklab(colors[32 - i]).lightness;
        CHECK(left < to_oklab(colors[i + 1]).lightness);
        CHECK(left == doctest::Approx(right).epsilon(0.01));
    }
}

TEST_CASE("steps look equally large") {
    // Rounding to bytes moves a colour by up to about 0.002; a step of 33 samples is 0.02 to 0.05.
    for (const ColorMap& map : {sequential_colors(), diverging_colors()}) {
        const std::vector<double> all = steps(samples(map));
        CHECK(least(all) > 0.02);
        CHECK(greatest(all) / least(all) < 1.25);
    }
}

TEST_CASE("colour-blind readers tell neighbours, both signs, and no value apart") {
    for (const Matrix* matrix : {&protanopia, &deuteranopia}) {
        const auto seen = [&](std::vector<Rgb> colors) {
            for (Rgb& color : colors) color = seen_with(*matrix, color);
            return colors;
        };
        const std::vector<Rgb> sequential = seen(samples(sequential_colors()));
        const std::vector<Rgb> diverging = seen(samples(diverging_colors()));
        CHECK(least(steps(sequential)) > 0.01);
        CHECK(least(steps(diverging)) > 0.01);
        for (std::size_t i = 0; i < 12; ++i)  // from a quarter of the range away from 0
            CHECK(difference(to_oklab(diverging[i]), to_oklab(diverging[32 - i])) > 0.1);
        CHECK(distance_from(sequential, seen_with(*matrix, no_value_color)) > 0.1);
        CHECK(distance_from(diverging, seen_with(*matrix, no_value_color)) > 0.1);
    }
}

TEST_CASE("no value is far from every colour that stands for one") {
    CHECK(distance_from(samples(sequential_colors()), no_value_color) > 0.12);
    CHECK(distance_from(samples(diverging_colors()), no_value_color) > 0.12);
    std::vector<Rgb> directions;
    for (int i = 0; i <= 36; ++i)
        for (int j = 0; j < 72; ++j) {
            const double theta = i * 0.0872664626, phi = j * 0.0872664626;  // 5 degrees
            directions.push_back(
                direction_color(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)));
        }
    CHECK(distance_from(directions, no_value_color) > 0.12);
}

TEST_CASE("a position outside gets the end's colour") {
    const ColorMap map = sequential_colors();
    CHECK(map(-1) == map(0));
    CHECK(map(INFINITY) == map(1));
    CHECK(map(NAN) == map(0));
}

TEST_CASE("a direction's components are red, green and blue") {
    CHECK(direction_color(1, -1, 0) == Rgb{255, 0, 128});  // 127.5 rounds up
    CHECK(direction_color(9, -9, 1) == Rgb{255, 0, 255});
}

TEST_CASE("differences: 0 alone is nearly white; the least of either sign is told from it and from the other sign") {
    const ColorMap map = difference_colors();
    constexpr double step = 1.0 / ColorMap::steps;
    for (const Matrix* matrix : {static_cast<const Matrix*>(nullptr), &protanopia, &deuteranopia}) {
        const auto at = [&](double position) {
            const Rgb color = map(position);
            return to_oklab(matrix ? seen_with(*matrix, color) : color);
        };
        CHECK(at(0.5).lightness > 0.94);
        CHECK(difference(at(0.5), at(0.5 + step)) > 0.09);
        CHECK(difference(at(0.5), at(0.5 - step)) > 0.09);
        for (int i = 1; i <= 128; i += 8) CHECK(difference(at(0.5 - i * step), at(0.5 + i * step)) > 0.1);
    }
    for (const double end : {0.0, 1.0}) CHECK(map(end) == diverging_colors()(end));
}
