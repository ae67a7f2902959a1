#include "output/value_words.hpp"

#include <doctest.h>

#include <limits>
#include <vector>

using namespace glassbox;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const Measurement& named(std::string_view name) { return *find_measurement(name); }

std::vector<std::string> told(const Measurement& what, std::vector<double> values) {
    const int width = static_cast<int>(values.size());
    const Channel channel{"value", width, 1, std::move(values)};
    const Summary summary = summarized(channel);
    std::vector<std::string> texts;
    for (const ColorWord& word : color_words(what, channel, summary, coloring_of(what, summary)))
        texts.push_back(word.text + " " + std::to_string(word.pixels));
    return texts;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("a verdict is a word") {
    CHECK(value_in_words(named("verdict"), 0) == "right");
    CHECK(value_in_words(named("verdict"), 3) == "wrong surface");
    CHECK(value_in_words(named("verdict"), no_value) == "no value");
    CHECK(value_in_short(named("verdict"), 2) == "wrong miss");
    CHECK(value_in_lines(named("verdict"), 2) == Texts{"wrong", "miss"});
    CHECK(told(named("verdict"), {0, 0, 2, no_value}) ==
          Texts{"right 2", "wrong hit 0", "wrong miss 1", "wrong surface 0", "no value 1"});
}

TEST_CASE("an infinite margin says what it means; a number has its unit") {
    CHECK(value_in_words(named("margin"), infinity) == "∞ (exactly 0, and known to be)");
    CHECK(value_in_words(named("margin"), -infinity) == "−∞ (computed as 0, or too large: nothing is known)");
    CHECK(value_in_words(named("margin"), 13.25) == "13.25 digits");
    CHECK(value_in_short(named("margin"), -infinity) == "−∞");
    CHECK(value_in_short(named("margin"), no_value) == "–");
    CHECK(value_in_words(named("deficit"), -infinity) == "−∞ (a difference of 0: all signs agree)");
    CHECK(value_in_words(named("depth"), infinity) == "∞");
}

TEST_CASE("what stands beside a scale: what lies outside, what is infinite, what has no value") {
    CHECK(told(named("margin"), {1, 2}) == Texts{"no value 0"});
    CHECK(told(named("margin"), {-infinity, infinity, infinity, -7, 99, 3}) ==
          Texts{"below 0: not decided 1", "below −4 1", "above 16 1",
                "−∞ (computed as 0, or too large: nothing is known) 1", "∞ (exactly 0, and known to be) 2",
                "no value 0"});
}

TEST_CASE("a difference tells how many are 0, positive and negative; 0 alone has the middle's colour") {
    Measurement what{"depth-minus-scalar:exact", "|D|", "", Scale::difference, Source::hit, {}, {}, {}, {}};
    what.infinity = what.minus_infinity = "one of the two is infinite";
    what.spacing = Spacing::symlog;
    CHECK(told(what, {0, 1e-9, -1e-12, 3, infinity, no_value, 0}) ==
          Texts{"0: no difference 2", "positive 2", "negative 1", "∞ (one of the two is infinite) 1", "no value 1"});
    CHECK(told(what, {0, 0}) == Texts{"0: no difference 2", "no value 0"});

    const Channel channel{"value", 3, 1, {0, 1e-300, 100}};
    const Summary summary = summarized(channel);
    for (const Spacing spacing : {Spacing::linear, Spacing::symlog, Spacing::log, Spacing::percentile}) {
        const Coloring coloring = coloring_of(what, summary, {}, spacing);
        CHECK(coloring.low == -100);  // 0 is in the middle, as far as the values reach to either side
        CHECK(coloring.high == 100);
        CHECK(coloring.spacing == (spacing == Spacing::linear ? Spacing::linear : Spacing::symlog));
        CHECK(coloring(0) == coloring.map(0.5));
        CHECK(coloring(1e-300) == coloring.map(0.5 + 1.0 / 256));
        CHECK(coloring(-1e-300) == coloring.map(0.5 - 1.0 / 256));
        CHECK(coloring(100) == coloring.map(1));
    }
}
