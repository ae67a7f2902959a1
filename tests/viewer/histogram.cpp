#include "viewer/model/overlay/histogram.hpp"

#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "viewer/model/overlay/difference.hpp"

using namespace glassbox;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::string_view one[] = {"value"};
const Measurement sequential{"value", "", "", Scale::sequential, Source::hit, {}, one, {}};
const Measurement diverging{"value", "", "", Scale::diverging, Source::hit, {}, one, {}};
const Measurement cosine{"value", "", "", Scale::diverging, Source::hit, std::pair{-1.0, 1.0}, one, {}};

Channel row(std::vector<double> values) {
    const int width = static_cast<int>(values.size());
    return {"value", width, 1, std::move(values)};
}

Histogram in_bins(const Channel& plane, const Coloring& coloring, int most) {
    return histogram(plane, summarized(plane), coloring, most);
}

std::vector<std::int64_t> counts(const Histogram& histogram) {
    std::vector<std::int64_t> result;
    for (const Bin& bin : histogram.bins) result.push_back(bin.count);
    return result;
}

/// The colours beside the bar.
std::vector<std::string> beside(const Distribution& distribution) {
    std::vector<std::string> texts;
    for (const ColorWord& word : distribution.words) texts.push_back(word.text);
    return texts;
}

std::int64_t counted(const Histogram& histogram) {
    const std::vector<std::int64_t> all = counts(histogram);
    return std::accumulate(all.begin(), all.end(), std::int64_t{0});
}

}  // namespace

TEST_CASE("a bin has its lower end and not its upper one; the last has both") {
    // Four bins from 0 to 2: [0, 0.5), [0.5, 1), [1, 1.5), [1.5, 2].
    const Channel plane = row({0, 0.25, 0.5, 0.75, 0.999, 1.5, 2});
    const Histogram found = in_bins(plane, coloring_of(sequential, summarized(plane)), 4);
    CHECK(counts(found) == std::vector<std::int64_t>{2, 3, 0, 2});
    CHECK(found.most == 3);
    CHECK(found.bins[1].from == 0.5);
    CHECK(found.bins[1].to == 1);
    CHECK_FALSE(found.whole);
}

TEST_CASE("a few whole numbers have a bin each") {
    const Channel plane = row({0, 3, 3, 1});
    const Histogram found = in_bins(plane, coloring_of(sequential, summarized(plane)), 64);
    CHECK(found.whole);
    CHECK(counts(found) == std::vector<std::int64_t>{1, 1, 0, 2});
    CHECK(found.bin_of(3) == 3);
}

TEST_CASE("many whole numbers share bins, and each bin has equally many of them") {
    // 0 to 9 in at most 4 bins: ceil(10 / 4) = 3 each, and one is left for the last: 0-2, 3-5, 6-8, 9.
    std::vector<double> values(10);
    std::iota(values.begin(), values.end(), 0);
    const Channel plane = row(values);
    const Histogram found = in_bins(plane, coloring_of(sequential, summarized(plane)), 4);
    CHECK(counts(found) == std::vector<std::int64_t>{3, 3, 3, 1});
    CHECK(found.bins.back().from == 9);
    CHECK(found.bins.back().to == 9);
}

TEST_CASE("what is not finite is in no bin") {
    const Channel plane = row({no_value, infinity, -infinity, 0.5, 1.5});
    const Distribution found = distribution(sequential, plane, {});
    CHECK(counted(found.histogram) == 2);
    CHECK_FALSE(found.histogram.bin_of(no_value));
    CHECK_FALSE(found.histogram.bin_of(infinity));
    CHECK(found.summary.missing == 1);
    CHECK(beside(found) == std::vector<std::string>{"−∞", "∞", "no value"});
}

TEST_CASE("without a finite value there are no bins") {
    const Channel plane = row({no_value, infinity});
    const Distribution found = distribution(sequential, plane, {});
    CHECK(found.histogram.bins.empty());
    CHECK_FALSE(found.histogram.bin_of(0));
}

TEST_CASE("one value has one bin, whatever it is") {
    for (const double value : {0.5, 0.0, 7.0, -1e300, 5e-324}) {
        const Channel plane = row({value, value});
        const Histogram found = in_bins(plane, coloring_of(sequential, summarized(plane)), 64);
        CHECK(counts(found) == std::vector<std::int64_t>{2});
    }
}

TEST_CASE("every finite value is in a bin that holds it, from the smallest to the largest doubles") {
    const double largest = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
    for (const std::vector<double>& values : {std::vector{-largest, -1., 0.5, largest},
                                              {0., least, 2 * least},
                                              {1., std::nextafter(1., 2.)},
                                              {.1, .2, .3}}) {
        const Channel plane = row(values);
        const Histogram found = in_bins(plane, coloring_of(sequential, summarized(plane)), 64);
        CHECK(counted(found) == static_cast<std::int64_t>(values.size()));
        std::vector<std::int64_t> searched(found.bins.size());
        for (const double value : values) ++searched[found.bin_of(value).value_or(0)];
        CHECK(counts(found) == searched);
        for (const double value : values) {
            const auto bin = found.bin_of(value);
            REQUIRE(bin);
            CHECK(found.bins[*bin].from <= value);
            CHECK(value <= found.bins[*bin].to);
        }
    }
}

TEST_CASE("a range that was set cuts: what lies outside is counted and has a colour of its own") {
    const Channel plane = row({0, 1, 2.5, 4, 9, 9, infinity, no_value});
    const Distribution found = distribution(sequential, plane, std::pair{1.0, 4.0});
    CHECK(beside(found) == std::vector<std::string>{"below 1", "above 4", "∞", "no value"});
    CHECK(found.words[0].pixels == 1);  // 0
    CHECK(found.words[1].pixels == 2);  // 9 and 9; ∞ is counted by itself
    CHECK(found.summary.positive_infinite == 1);
    CHECK(counted(found.histogram) == 3);  // 1, 2.5, 4
    CHECK(found.coloring(0) == below_color);
    CHECK(found.coloring(9) == above_color);
    CHECK(found.coloring(infinity) == infinity_color);
    CHECK(found.coloring(no_value) == no_value_color);
    CHECK(found.coloring(1) == found.coloring.map(0));
    CHECK(found.coloring(4) == found.coloring.map(1));
    const Measured measured{&sequential, {&plane, 1}};
    CHECK(colored(measured, std::pair{1.0, 4.0}).pixels.front() == below_color);
}

TEST_CASE("bins are as even on a logarithmic bar as on a linear one") {
    // From 1 to 10⁴ in 4 bins: a power of ten each.
    const Channel plane = row({1, 2, 9, 10, 500, 2000, 10000});
    const Coloring coloring = coloring_of(sequential, summarized(plane), {}, Spacing::log);
    const Histogram found = in_bins(plane, coloring, 4);
    CHECK_FALSE(found.whole);
    CHECK(found.bins[1].from == doctest::Approx(10));
    CHECK(counted(found) == 7);
    CHECK(found.bins[2].count == 1);
    CHECK(found.bins[3].count == 2);
}

TEST_CASE("brushed bins hold the values that they count, and no others") {
    const Channel plane = row({0, 0.25, 0.5, 0.75, 0.999, 1.5, 2});
    const Histogram found = in_bins(plane, coloring_of(sequential, summarized(plane)), 4);
    for (std::size_t first = 0; first < 4; ++first)
        for (std::size_t last = first; last < 4; ++last) {
            const auto [from, to] = values_of(found, first, last);
            std::int64_t in_bins_there = 0;
            for (std::size_t i = first; i <= last; ++i) in_bins_there += found.bins[i].count;
            CHECK(std::ranges::count_if(plane.values, [&, low = from, high = to](double v) {
                      return low <= v && v <= high;
                  }) == in_bins_there);
        }
}

TEST_CASE("0 keeps the middle of a map for both signs when the range that was set has it") {
    const Channel plane = row({-3.5, 0, 3.5});
    const Coloring found = coloring_of(diverging, summarized(plane), std::pair{-1.0, 3.0});
    CHECK(found(0) == diverging_colors()(0.5));
    CHECK(found(-1) == diverging_colors()(1.0 / 3));  // on a scale from -3 to 3
    CHECK(found(-1.5) == below_color);
    const Coloring above = coloring_of(diverging, summarized(plane), std::pair{1.0, 3.0});
    CHECK(above(1) == sequential_colors()(0));
    CHECK(above(0) == below_color);
}

TEST_CASE("a range that was set comes before a measurement's own") {
    const Channel plane = row({-0.5, 0.25});
    const Coloring found = coloring_of(cosine, summarized(plane), std::pair{0.0, 0.5});
    CHECK(found.limits() == std::pair{0.0, 0.5});
    CHECK(found(-0.5) == below_color);
    CHECK(coloring_of(cosine, summarized(plane)).limits() == std::pair{-1.0, 1.0});
}

TEST_CASE("none of the colours that say something else is in a map") {
    for (const ColorMap& map : {sequential_colors(), diverging_colors(), danger_colors()})
        for (int i = 0; i <= 256; ++i) {
            const Rgb c = map(i / 256.0);
            for (const Rgb other : {below_color, above_color, no_value_color, minus_infinity_color, infinity_color})
                CHECK(std::abs(c.red - other.red) + std::abs(c.green - other.green) + std::abs(c.blue - other.blue) >
                      60);
        }
}

TEST_CASE("how two pictures differ: how many pixels, where most, and eight times as bright") {
    Image a(3, 2, {100, 100, 100}), b = a;
    b.at(1, 0) = {103, 100, 100};
    b.at(2, 1) = {100, 60, 99};
    const Difference found = picture_difference(a, b);
    CHECK(found.pixels == 2);
    CHECK(found.greatest == 40);
    CHECK(found.where == Pixel{2, 1});
    CHECK(found.magnified.at(0, 0) == Rgb{0, 0, 0});
    CHECK(found.magnified.at(1, 0) == Rgb{24, 0, 0});   // 8 · 3
    CHECK(found.magnified.at(2, 1) == Rgb{0, 255, 8});  // 8 · 40 is more than 255; 8 · 1
}

TEST_CASE("equal pictures do not differ") {
    const Image a(2, 2, {1, 2, 3});
    const Difference found = picture_difference(a, a);
    CHECK(found.pixels == 0);
    CHECK(found.greatest == 0);
}

TEST_CASE("the bins of a difference: one of them lies about 0, and as many on either side") {
    Measurement difference = diverging;
    difference.scale = Scale::difference;
    difference.spacing = Spacing::symlog;
    const Distribution of = distribution(difference, {"value", 4, 1, {0, 0, -1.5, 1e-9}}, {});
    REQUIRE(of.histogram.bins.size() == 63);
    const Bin& middle = of.histogram.bins[31];
    CHECK(middle.from < 0);
    CHECK(middle.to > 0);
    CHECK(middle.count == 3);  // 1e-9 is far below a bin's width: symlog is linear up to 1.5/10⁴
    CHECK(of.histogram.bins.front().count == 1);
    CHECK(of.words.front().text == "0: no difference");
    CHECK(of.words.front().pixels == 2);
}
