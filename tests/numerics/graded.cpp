// Graded computes what its scalar computes, keeps a bound that holds, and answers only as surely as the bound allows.
#include "numerics/graded.hpp"

#include <doctest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include <intersect_sphere.hpp>
#include <sides.hpp>

using namespace glassbox;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void check_is(const GradedTruth& truth, bool holds, double sureness) {
    CHECK(truth.holds == holds);
    CHECK(truth.sureness == sureness);
}

}  // namespace

TEST_CASE("what needs both is as sure as the less sure one, and what one is enough for as the surer one") {
    const GradedTruth yes3{true, 3}, yes5{true, 5}, no2{false, 2}, no7{false, 7};
    check_is(yes3 & yes5, true, 3);
    check_is(yes3 & no2, false, 2);  // that one is enough for a no
    check_is(no2 & no7, false, 7);
    check_is(yes3 | yes5, true, 5);
    check_is(yes3 | no7, true, 3);
    check_is(no2 | no7, false, 2);
    check_is(yes3 != no2, true, 2);
    check_is(yes5 != yes3, false, 3);
    check_is(!no7, true, 7);
    CHECK(GradedTruth(true, 1.5).is_decided());
    CHECK_FALSE(GradedTruth(true, 1).is_decided());
}

TEST_CASE("numbers that nothing rounded are compared for sure") {
    check_is(Graded<float>(3) > Graded<float>(2), true, infinity);
    check_is(Graded<float>(3) == Graded<float>(3), true, infinity);
    check_is(Graded<double>(.1) > Graded<double>(.1), false, infinity);
}

// The float nearest to 0.1 is 0x1.99999ap-4, and the double lies 0x1.99999999999ap-4 − 0x1.99999ap-4 below it: that is
// all that is off.
TEST_CASE("rounding an input to float counts") {
    const Graded<float> tenth(.1);
    CHECK(tenth.value() == .1f);
    CHECK(tenth.bound().value == double(.1f));
    CHECK(tenth.bound().error >= double(.1f) - .1);
    CHECK(tenth.bound().error <= (double(.1f) - .1) * (1 + 0x1p-40));
}

// Products of whole numbers below 2^24 and their differences fit into 64 bits: the truth is known.
TEST_CASE("a·b − c·d in float has the float's own bits, a bound that holds, and no sure sign that is wrong") {
    std::mt19937 random(16);
    std::uniform_int_distribution<std::int64_t> any(-(1 << 24) + 1, (1 << 24) - 1), little(-3, 3);
    int sure = 0, open = 0;
    for (int i = 0; i < 100'000; ++i) {
        const std::int64_t a = any(random), b = any(random), c = a + little(random), d = b + little(random);
        const auto f = [](std::int64_t whole) { return static_cast<float>(whole); };
        if (std::abs(c) >= 1 << 24 || std::abs(d) >= 1 << 24) continue;
        const std::int64_t truth = a * b - c * d;
        const float plain = f(a) * f(b) - f(c) * f(d);
        const auto g = [](std::int64_t whole) { return Graded<float>(static_cast<double>(whole)); };
        const Graded<float> difference = g(a) * g(b) - g(c) * g(d);
        REQUIRE(difference.value() == plain);
        REQUIRE(std::abs(difference.bound().value - static_cast<double>(truth)) <= difference.bound().error);
        const GradedTruth positive = difference > Graded<float>(0);
        REQUIRE(positive.holds == (plain > 0));
        if (positive.is_decided()) REQUIRE(positive.holds == (truth > 0));
        ++(positive.is_decided() ? sure : open);
    }
    CHECK(sure > 1000);
    CHECK(open > 1000);
}

// With a, b and c of one sign a hit needs all three; of two signs a miss needs one of each, and of each the surest one.
TEST_CASE("side products: the margin is that of the sign that decides") {
    const auto number = [](double value, double error) {
        // value + e − e, with e so large that its rounding error is the bound that is wanted
        Graded<double> n(value);
        return error == 0 ? n : n + Graded<double>(error / Bounded::u) - Graded<double>(error / Bounded::u);
    };
    const auto ratio = [](const Graded<double>& n) { return (n > Graded<double>(0)).sureness; };
    const Graded<double> one = number(1, 0x1p-30), two = number(2, 0x1p-20), four = number(4, 0x1p-30);
    CHECK(ratio(one) > ratio(two));
    CHECK(ratio(four) > ratio(one));
    check_is(inside(Sides<Graded<double>>{one, two, four}), true, ratio(two));
    check_is(inside(Sides<Graded<double>>{-one, two, four}), false, ratio(one));
    check_is(inside(Sides<Graded<double>>{-two, one, four}), false, ratio(two));
}

TEST_CASE("overflow and no number leave everything open") {
    const Graded<float> huge = Graded<float>(3e38f) * Graded<float>(10.f);
    CHECK_FALSE((huge > Graded<float>(0)).is_decided());
    CHECK_FALSE((sqrt(Graded<double>(-1)) >= Graded<double>(0)).is_decided());
}

TEST_CASE("of two roots the one is taken that the scalar takes; where that is not sure nothing is known of it") {
    const Graded<double> behind(-1), ahead(2);
    CHECK(first_ahead(behind, ahead).value() == 2);
    CHECK(first_ahead(behind, ahead).bound().error == 0);
    const Graded<double> near_zero = Graded<double>(1) / Graded<double>(3) - Graded<double>(1 / 3.0);
    CHECK(std::isinf(first_ahead(near_zero, ahead).bound().error));
}
