#pragma once
#include <doctest.h>

#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>

namespace glassbox {
template <class Real>
struct Vec3;
}

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

/// "0.5 (0x1p-1)".
template <class Real>
std::string shown(Real number) {
    std::ostringstream out;
    out << std::setprecision(std::numeric_limits<Real>::max_digits10) << number << " (" << std::hexfloat << number
        << ")";
    return out.str();
}
extern template std::string shown(float);
extern template std::string shown(double);
extern template std::string shown(long double);

// Those of whole vectors are in stages/checks.hpp.
template <class Real>
double ulps(const Vec3<Real>& got, const Vec3<Real>& expected);
template <class Real>
std::string shown(const Vec3<Real>& vector);

/// A number or a vector that is compared, as far as double tells them apart.
struct Compared {
    std::array<double, 3> numbers{};
    int count = 0;  ///< how many of those; 0: something else is compared
};

template <class T>
Compared compared(const T& value) {
    if constexpr (std::is_arithmetic_v<T>) return {{static_cast<double>(value)}, 1};
    else if constexpr (requires { value.x, value.y, value.z; })
        return {{static_cast<double>(value.x), static_cast<double>(value.y), static_cast<double>(value.z)}, 3};
    else return {};
}

/// A check that failed: what was computed, where, and what should have come out.
struct Difference {
    const char* file;
    int line;
    const char* expression;
    std::string expected, got;
    double ulps;
    Compared should_be = {}, is = {};
};

// Count a check. These are functions, not a long macro, so that tests compile in half the time: a learner waits for
// them to compile after each change.
void passed();
void passed(const char* expression, int line, const Compared& should_be);
void failed(const Difference& difference);

template <class T>
void check_ulps(const T& got, const T& expected, double most, const char* expression, const char* file, int line) {
    const double apart = ulps(got, expected);
    if (apart <= most) return passed(expression, line, compared(expected));
    failed({file, line, expression, shown(expected), shown(got), apart, compared(expected), compared(got)});
}

}  // namespace glassbox::test

/// Fails, with expected, got and ulps, if the two are more than `most` ulps apart.
#define CHECK_ULPS(got, expected, most) glassbox::test::check_ulps((got), (expected), (most), #got, __FILE__, __LINE__)
