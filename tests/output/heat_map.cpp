#include "output/heat_map.hpp"

#include <doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "output/color_map.hpp"
#include "output/coloring.hpp"
#include "output/oklab.hpp"

using namespace glassbox;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::string_view one[] = {"value"};
constexpr std::string_view three[] = {"normal.x", "normal.y", "normal.z"};
constexpr std::string_view explanation =
    "a long explanation, which certainly has to be wrapped when the picture is small";

const Measurement sequential{"value", "|D|", explanation, Scale::sequential, Source::hit, {}, one, {}};
const Measurement sequential_fixed{"value",     "length² |D|²",      explanation, Scale::sequential,
                                   Source::hit, std::pair{0.0, 1.0}, one,         {}};
const Measurement diverging{"value", "", explanation, Scale::diverging, Source::hit, {}, one, {}};
const Measurement direction{"normal", "", explanation, Scale::direction, Source::hit, std::pair{-1.0, 1.0}, three, {}};

Channel row(std::vector<double> values) {
    const int width = static_cast<int>(values.size());
    return {"value", width, 1, std::move(values)};
}

std::vector<Rgb> colors(const Measurement& what, const Channel& plane) { return colored({&what, {&plane, 1}}).pixels; }

/// Whether the picture, each pixel enlarged, is part of the sheet.
bool contains(const Image& sheet, const Image& picture, int factor) {
    const auto matches = [&](int left, int top) {
        for (int y = 0; y < picture.height * factor; ++y)
            for (int x = 0; x < picture.width * factor; ++x)
                if (sheet.at(left + x, top + y) != picture.at(x / factor, y / factor)) return false;
        return true;
    };
    for (int top = 0; top + picture.height * factor <= sheet.height; ++top)
        for (int left = 0; left + picture.width * factor <= sheet.width; ++left)
            if (matches(left, top)) return true;
    return false;
}

/// Whether nothing touches the sheet's edge: text that is cut off would.
bool has_margin(const Image& sheet) {
    const auto white = [&](int x, int y) { return sheet.at(x, y) == Rgb{255, 255, 255}; };
    for (int x = 0; x < sheet.width; ++x)
        if (!white(x, 0) || !white(x, sheet.height - 1)) return false;
    for (int y = 0; y < sheet.height; ++y)
        for (int x = 0; x < 8; ++x)
            if (!white(x, y) || !white(sheet.width - 1 - x, y)) return false;
    return true;
}

}  // namespace

TEST_CASE("sequential: the least value is the first colour, the greatest the last") {
    const ColorMap map = sequential_colors();
    CHECK(colors(sequential, row({3, 7, 5, no_value})) == std::vector<Rgb>{map(0), map(1), map(0.5), no_value_color});
}

TEST_CASE("diverging: 0 is in the middle, and both sides have the same scale") {
    const ColorMap map = diverging_colors();
    CHECK(colors(diverging, row({-1, 0, 4})) == std::vector<Rgb>{map(0.375), map(0.5), map(1)});
}

TEST_CASE("a fixed range holds, and what lies outside gets the end's colour") {
    const ColorMap map = sequential_colors();
    CHECK(colors(sequential_fixed, row({-3, 0.25, 9})) == std::vector<Rgb>{map(0), map(0.25), map(1)});
}

TEST_CASE("infinite values do not stretch the scale, and have colours of their own") {
    const ColorMap map = sequential_colors();
    CHECK(colors(sequential, row({1, 2, 3, infinity, -infinity})) ==
          std::vector<Rgb>{map(0), map(0.5), map(1), infinity_color, minus_infinity_color});
}

TEST_CASE("danger: the worst values are bright, whichever end they are at, and −∞ is the brightest") {
    // From -4 to 16: 1 is a quarter of the way up, so three quarters up the map, whose bright end is the low one.
    Measurement margin{"value", "", "", Scale::danger, Source::hit, std::pair{-4.0, 16.0}, one, {}};
    margin.worst = Worst::least;
    const ColorMap map = danger_colors();
    CHECK(colors(margin, row({-4, 1, 16, -9, 99, -infinity, infinity})) ==
          std::vector<Rgb>{map(1), map(0.75), map(0), map(1), map(0), danger_minus_infinity_color,
                           danger_infinity_color});
    margin.worst = Worst::greatest;
    CHECK(colors(margin, row({-4, 1, 16})) == std::vector<Rgb>{map(0), map(0.25), map(1)});
}

TEST_CASE("danger: where a value raises an alarm the colours step up") {
    const auto lightness = [](double value) {
        return to_oklab(colors(*find_measurement("margin"), row({value}))[0]).lightness;
    };
    CHECK(lightness(-0.2) > lightness(0.2) + 0.1);
    for (double value = -4; value < 16; value += 0.5) CHECK(lightness(value) >= lightness(value + 0.5));
    CHECK(lightness(13) < 0.45);  // as safe as most pixels in double
    CHECK(lightness(-3) > 0.85);
}

TEST_CASE("alarm: 0 is dark, and one of many is bright") {
    const Measurement alarm{"undecided", "", "", Scale::alarm, Source::hit, {}, one, {}};
    const std::vector<Rgb> found = colors(alarm, row({0, 1, 1000}));
    CHECK(found[0] == danger_colors()(0));
    CHECK(to_oklab(found[1]).lightness > 0.6);
    CHECK(found[2] == danger_colors()(1));
    // Where every pixel raises it none is dark.
    CHECK(to_oklab(colors(alarm, row({1, 1}))[0]).lightness > 0.6);
}

TEST_CASE("words have a colour each, whichever of them there are") {
    static constexpr std::string_view words[] = {"right", "wrong hit", "wrong miss", "wrong surface"};
    Measurement verdict{"verdict", "", "", Scale::words, Source::hit, std::pair{0.0, 3.0}, one, {}};
    verdict.words = words;
    const std::vector<Rgb> all = colors(verdict, row({0, 1, 2, 3}));
    for (std::size_t i = 0; i < all.size(); ++i) {
        CHECK(colors(verdict, row({static_cast<double>(i)}))[0] == all[i]);
        for (std::size_t j = 0; j < i; ++j) CHECK(difference(to_oklab(all[i]), to_oklab(all[j])) > 0.15);
        if (i > 0) CHECK(to_oklab(all[i]).lightness > to_oklab(all[0]).lightness + 0.4);
    }
}

namespace {

double position_of(double value, const Channel& plane, Spacing spacing, const Measurement& what = sequential) {
    return coloring_of(what, summarized(plane, spacing), {}, spacing).position(value);
}

}  // namespace

TEST_CASE("log: equal ratios are equally far apart, and what is not above 0 lies below the scale") {
    const Channel plane = row({1, 10, 100, 0, -5});
    CHECK(position_of(10, plane, Spacing::log) == doctest::Approx(0.5));
    Measured measured{&sequential, {&plane, 1}};
    measured.spacing = Spacing::log;
    const std::vector<Rgb> found = colored(measured).pixels;
    CHECK(found[0] == sequential_colors()(0));
    CHECK(found[2] == sequential_colors()(1));
    CHECK(found[3] == below_color);
    CHECK(found[4] == below_color);
    // Nothing is above 0: linear.
    const Channel below = row({-4, -2, 0});
    CHECK(position_of(-2, below, Spacing::log) == 0.5);
}

TEST_CASE("symlog: 0 is in the middle, both signs alike, and small numbers are not lost beside large ones") {
    const Channel plane = row({-1e6, 1, 1e6});
    CHECK(position_of(0, plane, Spacing::symlog, diverging) == doctest::Approx(0.5));
    const double up = position_of(1e4, plane, Spacing::symlog, diverging);
    CHECK(up > 0.7);  // linearly it were 0.505
    CHECK(position_of(-1e4, plane, Spacing::symlog, diverging) == doctest::Approx(1 - up));
}

TEST_CASE("percentile: each colour has as many pixels") {
    std::vector<double> values;
    for (int i = 0; i <= 1000; ++i) values.push_back(std::pow(2.0, i / 10.0));
    const Channel plane = row(values);
    for (const int i : {0, 250, 500, 750, 1000})
        CHECK(position_of(values[static_cast<std::size_t>(i)], plane, Spacing::percentile) ==
              doctest::Approx(i / 1000.0).epsilon(0.01));
}

TEST_CASE("whatever the spacing, a place on the bar has a value whose place it is") {
    const Channel plane = row({0.001, 0.02, 0.5, 7, 8, 9, 1e5});
    for (const auto& each : spacings) {
        const Spacing spacing = each.value;
        CAPTURE(each.name);
        const Coloring coloring = coloring_of(sequential, summarized(plane, spacing), {}, spacing);
        for (const double place : {0.0, 0.1, 0.3, 0.5, 0.9, 1.0}) {
            // Between the percentiles of seven values there are steps.
            const double tolerance = spacing == Spacing::percentile ? 0.09 : 1e-9;
            CHECK(std::abs(coloring.position(coloring.value_at(place)) - place) <= tolerance);
        }
        CHECK(coloring.value_at(0) == 0.001);
        CHECK(coloring.value_at(1) == 1e5);
    }
}

TEST_CASE("diverging, but all of one sign: from the least to the greatest, or the picture would have one colour") {
    const ColorMap map = sequential_colors();
    CHECK(colors(diverging, row({13, 14, 15})) == std::vector<Rgb>{map(0), map(0.5), map(1)});
    CHECK(colors(diverging, row({-15, -13})) == std::vector<Rgb>{map(0), map(1)});
    CHECK(colors(diverging, row({0, 15}))[0] == diverging_colors()(0.5));
}

TEST_CASE("a constant has the middle's colour") {
    CHECK(colors(sequential, row({5, 5}))[0] == sequential_colors()(0.5));
    CHECK(colors(diverging, row({0, 0}))[0] == diverging_colors()(0.5));
}

TEST_CASE("the largest and the smallest doubles have a scale, too") {
    const ColorMap map = sequential_colors();
    const double most = std::numeric_limits<double>::max();
    const double tiny = std::numeric_limits<double>::denorm_min();
    CHECK(colors(sequential, row({-most, 0, most})) == std::vector<Rgb>{map(0), map(0.5), map(1)});
    CHECK(colors(sequential, row({0, tiny, 2 * tiny})) == std::vector<Rgb>{map(0), map(0.5), map(1)});
}

TEST_CASE("a direction is a colour; without one component it is none") {
    const Channel channels[] = {row({1, 0, 0}), row({0, -1, no_value}), row({0, 0, 1})};
    CHECK(colored({&direction, channels}).pixels == std::vector<Rgb>{{255, 128, 128}, {128, 0, 128}, no_value_color});
}

TEST_CASE("the sheet has the plane in it, pixel for pixel, or in whole multiples") {
    for (const auto& [width, height, factor] : {std::tuple{210, 30, 1}, {100, 40, 2}, {3, 2, 67}}) {
        Channel plane{"value", width, height, {}};
        for (int i = 0; i < width * height; ++i) plane.values.push_back(std::sin(i));
        const Measured measured{&sequential, {&plane, 1}};
        CHECK(contains(heat_map({&measured, 1}), colored(measured), factor));
    }
}

TEST_CASE("whatever the size and the values, nothing reaches the edge") {
    const double values[][3] = {{0, 1, 2},
                                {no_value, no_value, no_value},
                                {5, 5, 5},
                                {infinity, 1, -infinity},
                                {infinity, infinity, infinity},
                                {-1e300, 0, 1e300},
                                {-1.7e308, 0, 1.7e308},
                                {1e-300, 2e-300, 3.123456e-300},
                                {-5e-324, 0, 5e-324},
                                {-1.2345678901234567e-300, -1.2345678901234567e-300, -1.2345678901234567e-300},
                                {1, 1, 1 + 0x1p-52},
                                {0, 123456789, 999999999}};
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 1}, {20, 500}, {500, 20}, {1500, 40}})
        for (const auto& triple : values) {
            Channel plane{"value", width, height, {}};
            for (int i = 0; i < width * height; ++i) plane.values.push_back(triple[i % 3]);
            CAPTURE(plane.width);
            CAPTURE(triple[0]);
            CAPTURE(triple[2]);
            const std::vector<Channel> same(3, plane);
            int next = 0;
            for (const Measurement* what : {&sequential, &sequential_fixed, &diverging, &direction, &diverging}) {
                const Spacing spacing = spacings[static_cast<std::size_t>(next++) % spacings.size()].value;
                const Measured measured{what, std::span(same).first(what->channels().size()), spacing};
                CHECK(has_margin(heat_map({&measured, 1})));
            }
        }
}

TEST_CASE("several stand side by side, about in a square, without empty places if possible") {
    const Channel plane{"value", 300, 200, std::vector<double>(60000, 1)};
    const Measured measured{&sequential, {&plane, 1}};
    const Image single = heat_map({&measured, 1});
    for (const std::size_t count : {2u, 4u, 6u, 12u}) {
        const Image sheet = heat_map(std::vector<Measured>(count, measured));
        CHECK(has_margin(sheet));
        CHECK(sheet.width < 3 * sheet.height);
        CHECK(sheet.height < 3 * sheet.width);
        CHECK(sheet.width > single.width);
    }
}

TEST_CASE("the same channels make the same sheet, and no channels an empty one") {
    const Channel plane = row({1, 2, 3});
    const Measured measured{&sequential, {&plane, 1}};
    CHECK(heat_map({&measured, 1}).pixels == heat_map({&measured, 1}).pixels);
    CHECK(has_margin(heat_map({})));
}
