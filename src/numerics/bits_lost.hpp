#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "numerics/exact.hpp"
#include "numerics/tape.hpp"

namespace glassbox {

/// How many of a finite number's last bits are lost at that distance from the truth: log2(ulps + 1), where ulps is the
/// distance in units in the last place of the number. 0 for no distance, 1 for one ulp.
inline double bits_lost(long double number, const Dyadic::Long& distance, const Precision& precision) {
    int exponent = precision.min_exponent;
    if (number != 0) std::frexp(number, &exponent);
    const int last_place = std::max(exponent, precision.min_exponent) - precision.digits;
    return std::log2(static_cast<double>(Dyadic::Long(ldexp(distance, -last_place))) + 1);
}

/// |number − truth|, the number finite.
inline Dyadic::Long distance(long double number, const Exact& truth) {
    return abs((truth - Exact::from(number)).to_long());
}

/// How many of a computed number's last bits are lost; infinite if it is not finite.
template <class Real>
double bits_lost(Real computed, const Exact& truth) {
    if (!std::isfinite(computed)) return std::numeric_limits<double>::infinity();
    return bits_lost(computed, distance(computed, truth), Precision::of<Real>());
}

}  // namespace glassbox
