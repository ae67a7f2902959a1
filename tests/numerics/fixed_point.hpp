#pragma once
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

namespace glassbox::test {

using Whole = boost::multiprecision::cpp_int;

/// x · 2¹⁰⁷⁴, a whole number for every finite double: 2⁻¹⁰⁷⁴ is the smallest subnormal number, and all others are
/// multiples of it. Products of two such numbers count in units of 2⁻²¹⁴⁸. Nothing here is ever rounded.
inline Whole fixed_point(double x) {
    int exponent = 0;
    Whole whole = static_cast<long long>(std::ldexp(std::frexp(x, &exponent), 53));
    const int shift = exponent - 53 + 1074;
    return shift >= 0 ? Whole(whole << static_cast<unsigned>(shift)) : Whole(whole >> static_cast<unsigned>(-shift));
}

/// 1, that is 2¹⁰⁷⁴.
inline const Whole& one() {
    static const Whole value = fixed_point(1);
    return value;
}

}  // namespace glassbox::test
