#include "scene/orientation.hpp"

#include <doctest.h>

#include <cmath>
#include <limits>

using namespace glassbox;

TEST_CASE("Left, right, straight on") {
    CHECK(orientation({0, 0}, {1, 0}, {0, 1}) == 1);
    CHECK(orientation({0, 0}, {0, 1}, {1, 0}) == -1);
    CHECK(orientation({0, 0}, {1, 2}, {3, 6}) == 0);
    CHECK(orientation({1, 2}, {1, 2}, {3, 7}) == 0);
    CHECK(orientation({3, 7}, {1, 2}, {1, 2}) == 0);
}

TEST_CASE("Points beside a line by units in the last place (Kettner and others 2008)") {
    // p = (1/2 + i u, 1/2 + j u), u = 2⁻⁵³, and the line from (12,12) to (24,24), where x = y: p lies left of it if and
    // only if j > i. In plain double many signs are wrong.
    const double u = 0x1p-53;
    for (int i = 0; i < 64; ++i)
        for (int j = 0; j < 64; ++j)
            CHECK(orientation({0.5 + i * u, 0.5 + j * u}, {12, 12}, {24, 24}) == (j > i ? 1 : j < i ? -1 : 0));
}

TEST_CASE("Numbers whose products overflow or underflow, or do not know of each other") {
    const double large = std::numeric_limits<double>::max(), small = std::numeric_limits<double>::denorm_min();
    CHECK(orientation({-large, -large}, {large, -large}, {large, large}) == 1);
    CHECK(orientation({-large, -large}, {large, large}, {0, 0}) == 0);
    CHECK(orientation({-large, -large}, {large, large}, {0, small}) == 1);
    CHECK(orientation({0, 0}, {small, 0}, {0, small}) == 1);
    CHECK(orientation({0, 0}, {small, small}, {3 * small, 2 * small}) == -1);
    // (large, small) × (−large, small) = 2·large·small
    CHECK(orientation({0, 0}, {large, small}, {-large, small}) == 1);
}
