#pragma once
#include <doctest.h>

#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <string>

namespace glassbox::test {

/// How many units in the last place of `expected` lie between the two numbers; 0 for equal ones (two NaNs, too).
template <class Real>
double ulps(Real got, Real expected) {
    if (got == expected || (std::isnan(got) && std::isnan(expected))) return 0;
    if (!std::isfinite(got) || !std::isfinite(expected)) return std::numeric_limits<double>::infinity();
    const Real magnitude = std::abs(expected);
    const Real ulp = std::nextafter(magnitude, std::numeric_limits<Real>::infinity()) - magnitude;
    return static_cast<double>(std::abs(got - expected) / ulp);
}

/// "expected 0.5 (0x1p-1), got 0.25 (0x1p-2), 4.5e+15 ulps apart".
template <class Real>
std::string compared(Real got, Real expected) {
    std::ostringstream out;
    out << std::setprecision(std::numeric_limits<Real>::max_digits10) << "expected " << expected << " ("
        << std::hexfloat << expected << std::defaultfloat << "), got " << got << " (" << std::hexfloat << got
        << std::defaultfloat << "), " << std::setprecision(3) << ulps(got, expected) << " ulps apart";
    return out.str();
}

}  // namespace glassbox::test

/// Fails, with expected, got and ulps, if the two are more than `most` ulps apart.
#define CHECK_ULPS(got, expected, most) \
    CHECK_MESSAGE(glassbox::test::ulps((got), (expected)) <= (most), glassbox::test::compared((got), (expected)))
