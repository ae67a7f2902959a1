#pragma once
#include <cmath>
#include <concepts>

namespace glassbox {

/// A scalar that keeps only sizes: it drops signs, and both + and − add. A formula evaluated in it sums the absolute
/// values of all its terms: the size of everything that could cancel.
struct Magnitude {
    double size = 0;

    constexpr Magnitude() = default;
    template <std::floating_point Real>
    explicit Magnitude(Real value) : size(static_cast<double>(std::abs(value))) {}

    friend Magnitude operator-(Magnitude a) { return a; }

    friend Magnitude operator+(Magnitude a, Magnitude b) {
        // |a + b| ≤ |a| + |b|
        return Magnitude(a.size + b.size);
    }
    friend Magnitude operator-(Magnitude a, Magnitude b) {
        // |a − b| ≤ |a| + |b|: the signs are unknown
        return Magnitude(a.size + b.size);
    }
    friend Magnitude operator*(Magnitude a, Magnitude b) {
        // |ab| = |a||b|
        return Magnitude(a.size * b.size);
    }
};

}  // namespace glassbox
