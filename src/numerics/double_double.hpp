#pragma once
#include <cmath>
#include <optional>

#include "numerics/two_sum.hpp"

namespace glassbox {

/// A number as the sum of two doubles, like BoundedPair but without a bound of its own, and so in half the time: for
/// formulas whose error is bounded in advance. |low| ≤ u|high|, u = 2⁻⁵³.
///
/// What each operation is off, where nothing overflows, from the numbers that its operands are (see Joldes, Muller and
/// Popescu, 2017, for closer bounds); underflow comes to it, less than 2⁻¹⁰⁷⁰:
/// - difference and product of doubles: nothing;
/// - a ± b: 3.1u²(|a| + |b|). The lows' sum and what the highs' sum lost are u(|a| + |b|) each, rounded twice.
/// - a × b: 8.1u²|ab|; 3.1u²|ab| if one of them is a double, and nothing if both are.
/// - a/b: 20u²|a/b|. The first quotient is off relatively by 3.1u; the second, which is that much, by 3.1u of itself,
///   and by what was left over for it, 9.3u²|a|, is off.
/// - √a: 8u²√a. The first root is off by 1.6u, its correction by 3u of itself, and by half of 6.2u².
struct DoubleDouble {
    double high = 0, low = 0;

    DoubleDouble() = default;
    explicit DoubleDouble(double exact) : high(exact) {}
    DoubleDouble(double its_high, double its_low) : high(its_high), low(its_low) {}

    static DoubleDouble sum(double large, double small) {
        const double high = large + small;
        return {high, lost_in_sum(large, small, high)};
    }
    static DoubleDouble product(double a, double b) {
        const double high = a * b;
        return {high, std::fma(a, b, -high)};
    }

    friend DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }
    friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
        const double highs = a.high + b.high, lows = a.low + b.low;
        return sum(highs, lost_in_sum(a.high, b.high, highs) + lows);
    }
    friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
    DoubleDouble times(double b) const {
        const double product = high * b;
        return sum(product, std::fma(high, b, -product) + low * b);
    }
    friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
        if (b.low == 0) return a.times(b.high);
        if (a.low == 0) return b.times(a.high);
        const double product = a.high * b.high;
        return sum(product, std::fma(a.high, b.high, -product) + (a.high * b.low + a.low * b.high));
    }
    friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
        const double first = a.high / b.high;
        return sum(first, (a - b.times(first)).high / b.high);
    }
    /// Of a number above 0.
    friend DoubleDouble sqrt(const DoubleDouble& a) {
        const double first = std::sqrt(a.high);
        return sum(first, (a - product(first, first)).high / (2 * first));
    }
};

/// The double nearest to a number, if that is sure: where all that is no farther off than `error` rounds to one double.
inline std::optional<double> nearest_double(const DoubleDouble& number, double error) {
    // So much more that low ± off, rounded, is still beyond low ± error.
    const double off = (error + 0x1p-52 * std::abs(number.low)) * (1 + 0x1p-49);
    const double high = number.high;
    if (high + (number.low + off) == high && high + (number.low - off) == high && std::isfinite(high)) return high;
    return {};
}

}  // namespace glassbox
