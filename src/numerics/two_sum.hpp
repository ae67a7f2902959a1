#pragma once

namespace glassbox {

/// What the rounded sum of two doubles lacks: exactly, and a double itself, where nothing overflows; else NaN. (Knuth,
/// The Art of Computer Programming, volume 2, section 4.2.2.)
inline double lost_in_sum(double a, double b, double sum) {
    const double b_in_sum = sum - a;
    return (a - (sum - b_in_sum)) + (b - b_in_sum);
}

}  // namespace glassbox
