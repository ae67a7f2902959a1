// What DoubleDouble's operations are off, and what nearest_double is sure of, against numbers without any rounding.
#include "numerics/double_double.hpp"

#include <doctest.h>

#include <cmath>
#include <limits>

#include "doubles.hpp"
#include "numerics/exact.hpp"

using namespace glassbox;
using test::Doubles;

namespace {

Exact exact(const DoubleDouble& a) { return Exact(a.high) + Exact(a.low); }

/// |a − truth| ≤ factor · 2⁻¹⁰⁶ · size
bool is_within(const DoubleDouble& a, const Exact& truth, double factor, const Exact& size) {
    return compare(abs(exact(a) - truth), Exact(factor * 0x1p-106) * size) <= 0;
}

DoubleDouble any(Doubles& random) {
    const double high = random.sign() * random.positive(-60, 60);
    const double low = random.one_in(4) ? 0 : random.sign() * random.fraction() * 0x1p-53 * std::abs(high);
    return DoubleDouble::sum(high, low);
}

}  // namespace

TEST_CASE("DoubleDouble: no operation is off by more than is said of it") {
    Doubles random(61);
    int wrong = 0;
    for (int i = 0; i < 3000; ++i) {
        const DoubleDouble a = any(random);
        // Often nearly −a or a, so that sums cancel.
        const DoubleDouble b = random.one_in(3) ? a.times(1 + random.sign() * random.positive(-52, -2)) : any(random);
        const double d = random.sign() * random.positive(-60, 60);
        const Exact A = exact(a), B = exact(b), sizes = abs(A) + abs(B), AB = A * B;
        for (const DoubleDouble& one : {a, b, a + b, a * b}) wrong += std::abs(one.low) > 0x1p-53 * std::abs(one.high);
        wrong += !is_within(a + b, A + B, 3.1, sizes) + !is_within(a - b, A - B, 3.1, sizes);
        wrong +=
            !is_within(a * DoubleDouble(d), A * Exact(d), 3.1, abs(A * Exact(d))) + !is_within(a * b, AB, 8.1, abs(AB));
        wrong += compare(exact(DoubleDouble(a.high) * DoubleDouble(d)), Exact(a.high) * Exact(d)) != 0;
        wrong += compare(exact(DoubleDouble::sum(a.high, d)), Exact(a.high) + Exact(d)) != 0;
        wrong += !is_within(a / b, A / B, 20, abs(A / B));
        const DoubleDouble positive = a.high < 0 ? -a : a;
        const Exact root = sqrt(abs(A));
        wrong += !is_within(sqrt(positive), root, 8, root);
    }
    CHECK(wrong == 0);
}

TEST_CASE("nearest_double: what it tells is nearer to all that the number may be than any other double") {
    Doubles random(62);
    int wrong = 0, told = 0;
    constexpr int rounds = 3000;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (int i = 0; i < rounds; ++i) {
        const DoubleDouble a = any(random);
        const double error = std::abs(a.high) * random.positive(-110, -50);
        const std::optional<double> nearest = nearest_double(a, error);
        if (!nearest) continue;
        ++told;
        for (const double truly : {-error, 0.0, error}) {
            const Exact truth = exact(a) + Exact(truly), off = abs(truth - Exact(*nearest));
            for (const double beside : {std::nextafter(*nearest, -infinity), std::nextafter(*nearest, infinity)})
                wrong += compare(off, abs(truth - Exact(beside))) > 0;
        }
    }
    CHECK(wrong == 0);
    CHECK(told > rounds / 2);  // of errors below 2⁻⁵⁷ nearly all, and those are nine in ten
}

// 1 + 2⁻⁵³ is in the middle between two doubles, and 1 + 2⁻⁵⁴ a quarter of the way.
TEST_CASE("nearest_double: beside the middle between two doubles, and in it") {
    CHECK(nearest_double({1, 0x1p-54}, 0x1p-60) == 1);
    CHECK(nearest_double({1, 0x1p-53}, 0x1p-100) == std::nullopt);
    CHECK(nearest_double({1, -0x1p-54}, 0x1p-100) == std::nullopt);  // below 1 doubles are twice as near
    CHECK(nearest_double({1, 0}, 0x1p-54) == std::nullopt);
    CHECK(nearest_double({1 + 0x1p-52, 0}, 0x1p-54) == 1 + 0x1p-52);
}
