// Exact: a field with one square root at a time, whose every sign is known.
#include "numerics/exact.hpp"

#include <doctest.h>

#include <initializer_list>
#include <sstream>

#include "doubles.hpp"
#include "fixed_point.hpp"

using namespace glassbox;
using test::Doubles, test::fixed_point, test::one, test::Whole;

namespace {

Exact exact(double x) { return Exact(x); }

/// p + q√d.
Exact surd(double p, double q, double d) { return exact(p) + exact(q) * sqrt(exact(d)); }

/// A number of few bits, so that products stay readable, or any number.
double some(Doubles& random) {
    if (random.one_in(2)) return static_cast<double>(random.below(41)) - 20;
    return random.sign() * random.positive(-40, 40);
}

bool is(const Exact& a, const Exact& b) { return surely(a == b) && !possibly(a != b) && compare(a, b) == 0; }

bool is_less(const Exact& a, const Exact& b) {
    return surely(a < b) && surely(b > a) && surely(a <= b) && surely(b >= a) && surely(a != b) && !possibly(a >= b) &&
           compare(a, b) == -1 && compare(b, a) == 1 && (a - a).sign() == 0;
}

}  // namespace

TEST_CASE("a field: sums and products of numbers with the same root, or none, keep its laws") {
    Doubles random(21);
    for (int i = 0; i < 3'000; ++i) {
        const double d = random.one_in(3) ? 0 : random.positive(-40, 40);
        const Exact root = sqrt(exact(d));
        const auto number = [&] { return exact(some(random)) + exact(some(random)) * root; };
        const Exact x = number(), y = number(), z = number(), zero(0), unit(1);
        REQUIRE(is(x + y, y + x));
        REQUIRE(is(x * y, y * x));
        REQUIRE(is((x + y) + z, x + (y + z)));
        REQUIRE(is((x * y) * z, x * (y * z)));
        REQUIRE(is(x * (y + z), x * y + x * z));
        REQUIRE(is(x - x, zero));
        REQUIRE(is(x + zero, x));
        REQUIRE(is(x * unit, x));
        REQUIRE(is(-(-x), x));
        if (y.sign() != 0) {
            REQUIRE(is(y / y, unit));
            REQUIRE(is(x / y * y, x));
            REQUIRE(is((x + z) / y, x / y + z / y));
        }
        REQUIRE(abs(x).sign() == (x.sign() != 0));
        REQUIRE(is(abs(x), x.sign() < 0 ? -x : x));
    }
}

TEST_CASE("a root squared is what was under it") {
    Doubles random(22);
    for (int i = 0; i < 2'000; ++i) {
        const double n = random.positive(-1074, 1023), m = random.positive(-1074, 1023);
        const Exact quotient = exact(n) / exact(m);
        REQUIRE(is(sqrt(quotient) * sqrt(quotient), quotient));
    }
    CHECK(is(sqrt(exact(0)), exact(0)));
}

TEST_CASE("the sign of p + q√d, where both nearly cancel: the convergents of √2") {
    // p² − 2q² = ±1 in turn, from 1/1 on by (p, q) → (p + 2q, p + q): no fraction so small is closer to √2.
    double p = 1, q = 1;
    int sign = -1;
    for (; p < 0x1p53; sign = -sign) {
        CAPTURE(p);
        CHECK(surd(p, -q, 2).sign() == sign);
        CHECK(surd(-p, q, 2).sign() == -sign);
        CHECK(surd(p, q, 2).sign() == 1);
        CHECK(surd(-p, -q, 2).sign() == -1);
        CHECK((surd(p, -q, 2) * exact(0x1p-1000)).sign() == sign);
        const double next = p + 2 * q;
        q += p;
        p = next;
    }
    CHECK(surd(2, -1, 4).sign() == 0);
    CHECK(surd(0, 0, 2).sign() == 0);
    CHECK(surd(0, 5, 0).sign() == 0);
}

TEST_CASE("equal numbers written differently are equal") {
    CHECK(is(surd(0, 1, 8), surd(0, 2, 2)));                // √8 = 2√2
    CHECK(is(surd(1, 1, 8), surd(1, 2, 2)));                // 1 + √8 = 1 + 2√2
    CHECK(is(surd(1, 1, 4), exact(3)));                     // 1 + √4 = 3
    CHECK(is(surd(5, -1, 9), surd(0, 1, 4)));               // 5 − √9 = √4
    CHECK(is(sqrt(exact(1) / exact(2)), surd(0, 0.5, 2)));  // √½ = ½√2
    CHECK(is(surd(0, 1, 0x1p-1074), exact(0x1p-537)));
    CHECK(is(sqrt(exact(0x1p1022) * exact(0x1p1022)), exact(0x1p1022)));
    CHECK(is(exact(1) / surd(1, 1, 2), surd(-1, 1, 2)));  // 1/(1 + √2) = √2 − 1
    CHECK(is(exact(6) / exact(4), exact(1.5)));
    CHECK(is(exact(1) / exact(3), exact(2) / exact(6)));
}

TEST_CASE("a divisor whose root is a whole number: 1 / (2 + √4) = ¼, though 2² − 4 = 0") {
    CHECK(is(exact(1) / surd(2, 1, 4), exact(0.25)));
    CHECK(is(exact(1) / surd(-2, -1, 4), exact(-0.25)));
    CHECK(is(surd(1, 1, 4) / surd(2, 1, 4), exact(0.75)));
    CHECK(is(exact(0) / surd(3, 1, 9), exact(0)));
    CHECK((exact(1) / surd(2, 1, 4)).to_bounded().value == 0.25);
}

TEST_CASE("different roots that are nearly equal") {
    // (n + 1/2n)² = n² + 1 + 1/4n², so √(n² + 1) is the smaller one, by about 1/8n³: 2⁻⁷⁸ for n = 2²⁵.
    for (const double n : {1.0, 3.0, 1000.0, 0x1p25}) {
        CHECK(is_less(sqrt(exact(n * n + 1)), exact(n) + exact(1) / exact(2 * n)));
        CHECK(is_less(exact(n), sqrt(exact(n * n + 1))));
    }
    // √(n−1) + √(n+1) < 2√n; as a comparison of two numbers with one root each: √(n−1) < 2√n − √(n+1) is not of that
    // form, but √(n² − 1) < n is its square.
    CHECK(is_less(sqrt(exact(0x1p52 - 1)), exact(0x1p26)));
    // One ulp under the root.
    CHECK(is_less(sqrt(exact(2)), sqrt(exact(2 + 0x1p-51))));
    CHECK(is_less(surd(-1, -1, 2 + 0x1p-51), surd(-1, -1, 2)));
    // √2 + √3 against √10: the squares are 5 + 2√6 and 10, and 2√6 < 5.
    CHECK(is_less(surd(0, 1, 3), sqrt(exact(10)) - exact(1.4142)));
    CHECK(is_less(surd(1, 1, 3), surd(0, 1, 8) - exact(0.09)));  // 2.73205 < 2.73843
    // Tiny and huge.
    CHECK(is_less(sqrt(exact(0x1p-1074)), sqrt(exact(0x1.8p-1073))));
    CHECK(is_less(sqrt(exact(0x1p1022)), sqrt(exact(0x1.0000000000001p1022))));
}

TEST_CASE("comparisons of p + q√d with r + s√e, against whole numbers") {
    // The floor of 2¹²⁰⁰ (p + q√d) from the floor of a whole square root is off by 1 at most.
    Doubles random(23);
    const auto floored = [](double p, double q, double d) {
        const Whole square = Whole(fixed_point(q) * fixed_point(q) * fixed_point(d)) >> (3 * 1074 - 2 * 1200 - 800);
        const Whole root = sqrt(Whole(square >> 800));
        return Whole((fixed_point(p) << 126) + (q < 0 ? Whole(-root) : root));
    };
    for (int i = 0; i < 5'000; ++i) {
        const double p = some(random), q = some(random), d = std::abs(some(random));
        const bool near = random.one_in(2);
        const double r = near ? p : some(random), s = near ? q : some(random);
        const double e = near ? std::nextafter(d, random.sign() * 1e300) : std::abs(some(random));
        if (e < 0) continue;
        const Whole difference = floored(p, q, d) - floored(r, s, e);
        const int got = compare(surd(p, q, d), surd(r, s, e));
        if (abs(difference) > 4) REQUIRE(got == difference.sign());
        else REQUIRE(got == compare(exact(p) - exact(r), exact(0)));  // the same number, or 0 times different roots
    }
}

TEST_CASE("to_bounded gives the nearest double, as the hardware's own operations do, and a bound that holds") {
    Doubles random(24);
    for (int i = 0; i < 10'000; ++i) {
        const double x = random.any(), y = random.any();
        CAPTURE(x);
        CAPTURE(y);
        const auto check = [](const Bounded& got, double nearest, const Whole& numerator, const Whole& denominator) {
            REQUIRE((got.value == nearest || (!std::isfinite(got.value) && !std::isfinite(nearest))));
            if (!std::isfinite(nearest)) {
                REQUIRE(got.error == std::numeric_limits<double>::infinity());
                return;
            }
            const Whole distance = abs(Whole(numerator - fixed_point(nearest) * denominator));
            REQUIRE(distance <= fixed_point(got.error) * abs(denominator));
        };
        check((exact(x) + exact(y)).to_bounded(), x + y, fixed_point(x) + fixed_point(y), 1);
        check((exact(x) * exact(y)).to_bounded(), x * y, fixed_point(x) * fixed_point(y), one());
        if (y != 0) check((exact(x) / exact(y)).to_bounded(), x / y, fixed_point(x) * one(), fixed_point(y));
        const double root = std::sqrt(std::abs(x));
        const Bounded got = sqrt(exact(std::abs(x))).to_bounded();
        REQUIRE(got.value == root);
        const Whole low = fixed_point(got.value) - fixed_point(got.error),
                    high = fixed_point(got.value) + fixed_point(got.error), square = abs(fixed_point(x)) * one();
        REQUIRE(square <= high * high);
        if (low > 0) REQUIRE(low * low <= square);
    }
}

TEST_CASE("to_bounded of subnormal and huge numbers, and of those that nearly cancel") {
    CHECK(sqrt(exact(0x1p-1074)).to_bounded().value == 0x1p-537);
    CHECK(sqrt(exact(0x1.fffffffffffffp1023)).to_bounded().value == std::sqrt(0x1.fffffffffffffp1023));
    CHECK((exact(0x1p-1000) / exact(0x1.8p60)).to_bounded().value == 0x1p-1000 / 0x1.8p60);
    // p/q near √2, the 20th convergent: p − q√2 = −1/(p + q√2), by p² − 2q² = −1 … here p² − 2q² = 1.
    const double p = 22619537, q = 15994428;
    const Bounded rest = surd(p, -q, 2).to_bounded();
    CHECK(rest.value == doctest::Approx(1 / (p + q * std::sqrt(2.0))).epsilon(1e-15));
    CHECK(rest.error <= 0x1p-53 * rest.value * 1.0001);
    CHECK(exact(0).to_bounded().error == 0);
    for (const double x : {1.0, -3.5, 0x1p-1074, 0x1p1023}) {
        CHECK(exact(x).to_bounded().value == x);
        CHECK(exact(x).to_bounded().error <= std::max(std::abs(x) * 0x1p-100, Bounded::underflow));
    }
}
