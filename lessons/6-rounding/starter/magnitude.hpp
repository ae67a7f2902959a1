#pragma once
#include <cmath>
#include <concepts>
#include <not_written.hpp>

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
        // Your turn: how large a sum can be
        return not_written<Magnitude>("Magnitude + Magnitude");
    }
    friend Magnitude operator-(Magnitude a, Magnitude b) {
        // Your turn: how large a difference can be
        return not_written<Magnitude>("Magnitude - Magnitude");
    }
    friend Magnitude operator*(Magnitude a, Magnitude b) {
        // Your turn: how large a product can be
        return not_written<Magnitude>("Magnitude * Magnitude");
    }
};

}  // namespace glassbox
