// What the other tests measure with: how far apart two numbers or vectors are.
#include <doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <support/ulps.hpp>

using glassbox::test::shown, glassbox::test::ulps;

namespace {

using Three = std::array<double, 3>;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("numbers: units in the last place of the expected one") {
    CHECK(ulps(1.0, 1.0) == 0);
    CHECK(ulps(0.0, -0.0) == 0);
    CHECK(ulps(1 + 0x1p-52, 1.0) == 1);  // above 1 doubles are 2^-52 apart
    CHECK(ulps(1 - 0x1p-53, 1.0) == .5);
    CHECK(ulps(1 + 0x1p-23f, 1.0f) == 1);
    CHECK(ulps(not_a_number, not_a_number) == 0);
    CHECK(ulps(not_a_number, 1.0) == inf);
    CHECK(ulps(inf, 1.0) == inf);
}

TEST_CASE("vectors: the component that is furthest off, in units in the last place of the length") {
    CHECK(ulps(Three{1, 2, 3}, Three{1, 2, 3}) == 0);
    // |(3, 4, 0)| = 5, above 4, where doubles are 2^-50 apart.
    CHECK(ulps(Three{3, 4 + 0x1p-50, 0x1p-49}, Three{3, 4, 0}) == 2);
}

TEST_CASE("a vector that is not a number in one component is near no other, wherever that stands") {
    for (const Three& got : {Three{not_a_number, 2, 3}, Three{1, not_a_number, 3}, Three{1, 2, not_a_number}})
        CHECK_FALSE(ulps(got, Three{1, 2, 3}) <= 1e300);
    CHECK_FALSE(ulps(Three{1, 2, 3}, Three{1, not_a_number, 3}) <= 1e300);
}

TEST_CASE("shown") {
    CHECK(shown(.5) == "0.5 (0x1p-1)");
    CHECK(shown(Three{.5, 1, 0}) == "(0.5, 1, 0)");
}
