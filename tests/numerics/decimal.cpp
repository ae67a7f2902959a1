// Decimals are exact, and a printed bound is never below the bound.
#include "numerics/decimal.hpp"

#include <doctest.h>

#include <cstdlib>

#include "doubles.hpp"
#include "fixed_point.hpp"
#include "numerics/printed_bound.hpp"

using namespace glassbox;
using test::Doubles, test::fixed_point, test::one, test::Whole;

namespace {

/// The sign of a printed number minus a double, found in whole numbers: p · 10ᵉ against x, both times 2¹⁰⁷⁴ and, for
/// e < 0, times 10⁻ᵉ.
int compared(const std::string& printed, double x) {
    Whole digits = 0, scale = 1;
    int exponent = 0;
    const std::size_t e = printed.find('e');
    if (e != std::string::npos) exponent = std::atoi(printed.c_str() + e + 1);
    bool behind_point = false;
    for (const char c : printed.substr(0, e)) {
        if (c == '.') behind_point = true;
        if (c < '0' || c > '9') continue;
        digits = digits * 10 + (c - '0');
        exponent -= behind_point;
    }
    if (printed.front() == '-') digits = -digits;
    digits *= one();
    for (; exponent > 0; --exponent) digits *= 10;
    for (; exponent < 0; ++exponent) scale *= 10;
    return digits.compare(Whole(fixed_point(x) * scale));
}

std::string text(double x) { return Decimal(x).text(); }

}  // namespace

TEST_CASE("a double is a decimal, to its last digit") {
    CHECK(text(0) == "0");
    CHECK(text(-2500) == "-2500");
    CHECK(text(0.25) == "0.25");
    CHECK(text(0x1p-10) == "0.0009765625");       // 1/1024
    CHECK(text(0x1p-17) == "7.62939453125e-06");  // 1/131072
    CHECK(text(1e22) == "1e+22");
    CHECK(text(12345678) == "12345678");
    // 0.1 is the double 3602879701896397 · 2^-55.
    CHECK(text(0.1) == "0.1000000000000000055511151231257827021181583404541015625");
    Doubles random(21);
    for (int i = 0; i < 2'000; ++i) {
        const double x = random.any();
        REQUIRE(compared(text(x), x) == 0);
        REQUIRE(Decimal(text(x)) == Decimal(x));
    }
}

TEST_CASE("sums, products, comparisons and places") {
    CHECK((Decimal("0.1") + Decimal("2.05") - Decimal("1e-3")).text() == "2.149");
    CHECK((Decimal("-1.5") * Decimal("4e-2")).text() == "-0.06");
    CHECK(Decimal("2.50") == Decimal("25e-1"));
    CHECK(Decimal("-3e-10") <= Decimal("-2.9E-10"));
    CHECK_FALSE(Decimal("0.1") == Decimal(0.1));
    CHECK(Decimal("350").first_place() == 2);
    CHECK(Decimal("350").last_place() == 1);
    CHECK(Decimal("0.0350").first_place() == -2);
    CHECK(Decimal("0.0350").last_place() == -3);
    CHECK(Decimal("1.25").rounded(-1).text() == "1.3");
    CHECK(Decimal("-1.24").rounded(-1).text() == "-1.2");
    CHECK(Decimal("0.4").rounded(0).text() == "0");
    CHECK(Decimal("31.01").rounded_up(2).text() == "32");
    CHECK(Decimal("31").rounded_up(2).text() == "31");
    CHECK(Decimal("9.91").rounded_up(2).text() == "10");
}

// 2^-53 is 1.1102…e-16: two digits rounded to nearest would be 1.1e-16, and too few.
TEST_CASE("a printed bound is the least of two digits that is not below the bound and what the value's print is off") {
    CHECK(bound_beside("1", 1, 0x1p-53) == "1.2e-16");
    CHECK(bound_beside("2500", 2500, 0) == "0");
    CHECK(bound_beside("3", 3, 7.2) == "7.3");           // the double 7.2 is 7.2000000000000001776
    CHECK(bound_beside("3", 3, 1.6) == "1.7");           // the double 1.6 is 1.6000000000000000888
    CHECK(bound_beside("3", 3, 0.7) == "0.7");           // the double 0.7 is 0.6999999999999999556
    CHECK(bound_beside("0.3", 0.3125, 0.25) == "0.27");  // 0.25 + 0.0125 = 0.2625
    Doubles random(22);
    for (int i = 0; i < 5'000; ++i) {
        const double value = random.any(), error = std::abs(random.any());
        const std::string printed = value_beside(value, error), bound = bound_beside(printed, value, error);
        CAPTURE(printed);
        CAPTURE(bound);
        const Decimal off = abs(Decimal(printed) - Decimal(value));
        REQUIRE(compared(bound, error) >= 0);
        REQUIRE(Decimal(error) + off <= Decimal(bound));
        if (error == 0) {
            REQUIRE(std::strtod(printed.c_str(), nullptr) == value);
            continue;
        }
        // Two digits: at most a tenth above. The value's rounding is half of the bound's second place at most, or half
        // of the value's 17th.
        const Decimal last = Decimal::power_of_ten(Decimal(value).first_place() - 16);
        REQUIRE((off <= Decimal(error) * Decimal("0.05") || off <= last));
        REQUIRE(Decimal(bound) <= (Decimal(error) + off) * Decimal("1.1"));
    }
}

TEST_CASE("a value is printed down to its bound's second digit, but no further than doubles differ") {
    CHECK(value_beside(2 / 3.0, 1.5e-4) == "0.66667");             // 1.5e-4: to the place of 1e-5
    CHECK(value_beside(2 / 3.0, 1e-17) == "0.66666666666666663");  // 2/3 as a double is 0.666666666666666629…
    CHECK(value_beside(2500, 3.1e-10) == "2500");                  // and not 2500.00000000000
    CHECK(value_beside(246277123456.75, 3.1e12) == "2.5e+11");     // two digits at least: the sign is seen
    CHECK(value_beside(0, 1e-3) == "0");
    CHECK(value_beside(0.59375, 0) == "0.59375");  // 19/32, exactly
    CHECK(value_beside(0.1, 0) == "0.1");
}

TEST_CASE("the shortest form of a bound to print is above the bound, as a decimal too") {
    CHECK(bound_to_print(0) == 0);
    Doubles random(23);
    for (int i = 0; i < 5'000; ++i) {
        const double error = random.positive(-1074, 1022), printed = bound_to_print(error);
        REQUIRE(std::strtod(shortest(printed).c_str(), nullptr) == printed);
        REQUIRE(compared(shortest(printed), error) > 0);
        REQUIRE(printed <= std::nextafter(error, HUGE_VAL));
    }
}
