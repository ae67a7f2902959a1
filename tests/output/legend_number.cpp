#include "output/legend_number.hpp"

#include <doctest.h>

#include <cmath>

using namespace glassbox;

namespace {

std::vector<std::string> labels(double low, double high, int most, bool whole = false) {
    std::vector<std::string> all;
    for (const Tick& tick : ticks(low, high, most, whole)) all.push_back(tick.label);
    return all;
}

using Labels = std::vector<std::string>;

}  // namespace

TEST_CASE("numbers as a reader writes them") {
    CHECK(legend_number(0) == "0");
    CHECK(legend_number(-0.0) == "0");
    CHECK(legend_number(471.23456) == "471.2");
    CHECK(legend_number(12345.678) == "12346");
    CHECK(legend_number(-0.05) == "−0.05");
    CHECK(legend_number(123456789) == "123456789");
    CHECK(legend_number(1e300) == "10³⁰⁰");
    CHECK(legend_number(-1.5e-7) == "−1.5×10⁻⁷");
    CHECK(legend_number(-INFINITY) == "−∞");
    CHECK(legend_number(NAN) == "no value");
    CHECK(legend_number(1 + 0x1p-52, 17) == "1.0000000000000002");
}

TEST_CASE("digits enough to tell the ends apart") {
    CHECK(digits_between(0, 1) == 4);
    CHECK(digits_between(-1.7e308, 1.7e308) == 4);  // their difference is infinite
    // 100.0001 and 100.0002 differ in the seventh digit; two more show where in between.
    CHECK(digits_between(100.0001, 100.0002) >= 7);
    CHECK(legend_number(100.0001, digits_between(100.0001, 100.0002)) == "100.0001");
    CHECK(digits_between(1, 1 + 0x1p-52) == 17);
}

TEST_CASE("ticks at round numbers") {
    CHECK(labels(0, 1, 5) == Labels{"0", "0.2", "0.4", "0.6", "0.8", "1"});
    CHECK(labels(300.1, 400.1, 6) == Labels{"320", "340", "360", "380", "400"});
    CHECK(labels(-1, 1, 4) == Labels{"−1", "−0.5", "0", "0.5", "1"});
    CHECK(labels(0, 4e300, 4) == Labels{"0", "10³⁰⁰", "2×10³⁰⁰", "3×10³⁰⁰", "4×10³⁰⁰"});
}

TEST_CASE("a count has whole ticks") {
    CHECK(labels(0, 2, 10, true) == Labels{"0", "1", "2"});
    CHECK(labels(0, 6, 3, true) == Labels{"0", "2", "4", "6"});
}

TEST_CASE("no ticks where there is no room, and never very many") {
    CHECK(ticks(1, 1, 5, false).empty());
    CHECK(ticks(-1.7e308, 1.7e308, 5, false).empty());
    CHECK(ticks(1, INFINITY, 5, false).empty());
    for (const auto& [low, high] :
         {std::pair{1.0, 1 + 0x1p-52}, {0.0, 5e-324}, {1e-300, 3e-300}, {-7.3, 1e6}, {1e15, 1e15 + 1}})
        CHECK(ticks(low, high, 7, false).size() <= 8);
}
