#include <support/ulps.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace glassbox::test {

template <class Real>
double ulps(Real got, Real expected) {
    if (got == expected || (std::isnan(got) && std::isnan(expected))) return 0;
    if (!std::isfinite(got) || !std::isfinite(expected)) return std::numeric_limits<double>::infinity();
    const Real magnitude = std::abs(expected);
    const Real ulp = std::nextafter(magnitude, std::numeric_limits<Real>::infinity()) - magnitude;
    return static_cast<double>(std::abs(got - expected) / ulp);
}

template <class Real>
double ulps(const std::array<Real, 3>& got, const std::array<Real, 3>& expected) {
    if (got == expected) return 0;
    const Real size = std::hypot(expected[0], expected[1], expected[2]);
    const Real ulp = std::nextafter(size, std::numeric_limits<Real>::infinity()) - size;
    Real most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Real off = std::abs(got[i] - expected[i]);
        if (off > most || std::isnan(off)) most = off;
        if (std::isnan(most)) break;
    }
    return static_cast<double>(most / ulp);
}

template <class Real>
std::string shown(Real number) {
    std::ostringstream out;
    out << std::setprecision(std::numeric_limits<Real>::max_digits10) << number << " (" << std::hexfloat << number
        << ")";
    return out.str();
}

template <class Real>
std::string shown(const std::array<Real, 3>& vector) {
    std::ostringstream out;
    out << std::setprecision(std::numeric_limits<Real>::max_digits10) << '(' << vector[0] << ", " << vector[1] << ", "
        << vector[2] << ')';
    return out.str();
}

template <class Real>
void check_ulps(const std::array<Real, 3>& got, const std::array<Real, 3>& expected, double most,
                const char* expression, const char* file, int line) {
    double apart = ulps(got, expected);
    if (apart <= most) return passed(expression, line, compared(expected));
    if (most == 0) apart = std::max({ulps(got[0], expected[0]), ulps(got[1], expected[1]), ulps(got[2], expected[2])});
    failed({file, line, expression, shown(expected), shown(got), apart, compared(expected), compared(got)});
}

template <class Real>
void check_within(Real got, Real expected, Real most, const char* expression, const char* file, int line) {
    if (std::abs(got - expected) <= most) return passed(expression, line, compared(expected));
    failed(
        {file, line, expression, shown(expected), shown(got), ulps(got, expected), compared(expected), compared(got)});
}

GLASSBOX_CHECKED_IN(, float);
GLASSBOX_CHECKED_IN(, double);
GLASSBOX_CHECKED_IN(, long double);

}  // namespace glassbox::test
