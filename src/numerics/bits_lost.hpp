#pragma once
#include <cmath>
#include <limits>

#include "numerics/exact.hpp"

namespace glassbox {

/// How many of a number's last bits are not those of the true one: log2(ulps + 1), with ulps the distance between the
/// two in units in the last place of the computed one. 0 where it is the true number itself, 1 for one ulp.
template <class Real>
double bits_lost(Real computed, const Exact& truth) {
    if (!std::isfinite(computed)) return std::numeric_limits<double>::infinity();
    const Real size = std::abs(computed);
    const Real ulp = std::nextafter(size, std::numeric_limits<Real>::infinity()) - size;
    const auto head = static_cast<double>(computed);  // a long double is the sum of two doubles
    const auto tail = static_cast<double>(computed - static_cast<Real>(head));
    const Exact distance = Exact(head) + Exact(tail) - truth;
    const auto ulps = static_cast<double>(abs(distance.to_long()) / Dyadic::Long(ulp));
    return std::log2(ulps + 1);
}

}  // namespace glassbox
