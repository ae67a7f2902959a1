#pragma once
#include <array>
#include <string>
#include <type_traits>

namespace glassbox::test {

/// How many units in the last place of `expected` lie between the two numbers; 0 for equal ones (two NaNs, too).
template <class Real>
double ulps(Real got, Real expected);

/// How far two vectors are apart, component by component, in units in the last place of the larger one's length.
template <class Real>
double ulps(const std::array<Real, 3>& got, const std::array<Real, 3>& expected);

/// "0.5 (0x1p-1)".
template <class Real>
std::string shown(Real number);

/// "(0.5, 1, 0)".
template <class Real>
std::string shown(const std::array<Real, 3>& vector);

/// A number or a vector that is compared, as far as double tells them apart.
struct Compared {
    std::array<double, 3> numbers{};
    int count = 0;  ///< how many of those; 0: something else is compared
};

template <class T>
Compared compared(const T& value) {
    if constexpr (std::is_arithmetic_v<T>) return {{static_cast<double>(value)}, 1};
    else return {};
}
template <class Real>
Compared compared(const std::array<Real, 3>& vector) {
    return {{static_cast<double>(vector[0]), static_cast<double>(vector[1]), static_cast<double>(vector[2])}, 3};
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

// Count a check. These are functions, not a long macro, and what can be is compiled once, in ulps.cpp: a learner waits
// for the tests to compile after each change.
void passed();
void passed(const char* expression, int line, const Compared& should_be);
void failed(const Difference& difference);

template <class T>
void check_ulps(const T& got, const T& expected, double most, const char* expression, const char* file, int line) {
    const double apart = ulps(got, expected);
    if (apart <= most) return passed(expression, line, compared(expected));
    failed({file, line, expression, shown(expected), shown(got), apart, compared(expected), compared(got)});
}

/// Of vectors. What must be right in every bit is told in ulps of its components: its length hides small ones.
template <class Real>
void check_ulps(const std::array<Real, 3>& got, const std::array<Real, 3>& expected, double most,
                const char* expression, const char* file, int line);

/// For differences that cancel, where ulps of the (tiny) result would say nothing.
template <class Real>
void check_within(Real got, Real expected, Real most, const char* expression, const char* file, int line);

// What is compiled once, in ulps.cpp: declared by `extern`, made by nothing before it.
#define GLASSBOX_CHECKED_IN(linkage, Real)                                                                        \
    linkage template double ulps(Real, Real);                                                                     \
    linkage template double ulps(const std::array<Real, 3>&, const std::array<Real, 3>&);                         \
    linkage template std::string shown(Real);                                                                     \
    linkage template std::string shown(const std::array<Real, 3>&);                                               \
    linkage template void check_ulps(const Real&, const Real&, double, const char*, const char*, int);            \
    linkage template void check_ulps(const std::array<Real, 3>&, const std::array<Real, 3>&, double, const char*, \
                                     const char*, int);                                                           \
    linkage template void check_within(Real, Real, Real, const char*, const char*, int)
GLASSBOX_CHECKED_IN(extern, float);
GLASSBOX_CHECKED_IN(extern, double);
GLASSBOX_CHECKED_IN(extern, long double);

}  // namespace glassbox::test

/// Fails, with expected, got and ulps, if the two are more than `most` ulps apart.
#define CHECK_ULPS(got, expected, most) glassbox::test::check_ulps((got), (expected), (most), #got, __FILE__, __LINE__)
