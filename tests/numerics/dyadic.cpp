// Dyadic represents every finite double, and adds and multiplies, without rounding.
#include "numerics/dyadic.hpp"

#include <doctest.h>

#include <initializer_list>

#include "doubles.hpp"
#include "fixed_point.hpp"

using namespace glassbox;
using test::Doubles, test::fixed_point, test::one, test::Whole;

namespace {

/// A whole number of at most 1 + 2 · 2098 bits would not fit a Dyadic::Long: compare by what is left after subtracting.
bool is(const Dyadic& a, double x) { return (a - Dyadic(x)).sign() == 0; }

}  // namespace

TEST_CASE("every kind of double comes through unchanged") {
    constexpr double largest = std::numeric_limits<double>::max();
    for (const double x : {0.0, -0.0, 1.0, -1.0, 0.1, 3.0, 0x1p-1074, 0x1.fffffffffffffp-1023, 0x1p-1022, -0x1p1023,
                           largest, -largest, 0x1p53 + 2, 1 + 0x1p-52}) {
        CHECK(static_cast<double>(Dyadic(x).to_long()) == x);
        CHECK(Dyadic(x).sign() == (x > 0) - (x < 0));
    }
    Doubles random(11);
    for (int i = 0; i < 20'000; ++i) {
        const double x = random.any();
        REQUIRE(static_cast<double>(Dyadic(x).to_long()) == x);
        REQUIRE(is(Dyadic(x), x));
    }
}

TEST_CASE("sums, differences and products are exact") {
    // (a + b)c − d: signs agree with those of the fixed-point numbers, also where d is the result's nearest double.
    Doubles random(12);
    for (int i = 0; i < 20'000; ++i) {
        const double a = random.any(), b = random.one_in(3) ? -std::nextafter(a, 0) : random.any(), c = random.any();
        const Dyadic result = (Dyadic(a) + Dyadic(b)) * Dyadic(c);
        const Whole truth = (fixed_point(a) + fixed_point(b)) * fixed_point(c);
        REQUIRE(result.sign() == truth.sign());
        const auto nearest = static_cast<double>(result.to_long());
        if (!std::isfinite(nearest)) continue;
        const Whole rest = truth - fixed_point(nearest) * one();
        REQUIRE((result - Dyadic(nearest)).sign() == rest.sign());
        REQUIRE((-result + Dyadic(nearest)).sign() == -rest.sign());
    }
}

TEST_CASE("terms may be 2²⁰⁹⁷ times apart, and cancel all the same") {
    const Dyadic huge(0x1p1023), tiny(0x1p-1074);
    CHECK((huge + tiny - huge - tiny).sign() == 0);
    CHECK((huge + tiny - huge).sign() == 1);
    // (H + T)(H − T) = H² − T²
    CHECK(((huge + tiny) * (huge - tiny) - huge * huge + tiny * tiny).sign() == 0);
}

TEST_CASE("alike is about how a number is written, not what it is") {
    CHECK(is_written_alike(Dyadic(6), Dyadic(6)));
    CHECK(is_written_alike(Dyadic(0), Dyadic(5) - Dyadic(5)));
    const Dyadic two = Dyadic(1) + Dyadic(1);
    CHECK((two - Dyadic(2)).sign() == 0);
}
