#pragma once
#include <cmath>
#include <limits>

#include <floating_point.hpp>
#include <not_written.hpp>

#include <kleene.hpp>

namespace glassbox {

/// A double with a bound on its error: |true − value| ≤ error, guaranteed through every operation, underflow and
/// overflow included. An error that is infinite or NaN says that nothing is known.
///
/// Each operation adds the operands' errors, propagated to first and second order, and its own rounding error: at most
/// u|value|, u = 2⁻⁵³, and at most 2⁻¹⁰⁷⁵ where the result underflows, for which it adds 2⁻¹⁰²¹ (a normal number:
/// adding subnormal ones is slow). The bound is itself computed in doubles; `up` covers its few roundings. See Higham,
/// Accuracy and Stability of Numerical Algorithms (2002), chapters 2 and 3.
struct Bounded {
    double value = 0;
    double error = 0;

    constexpr Bounded() = default;
    explicit constexpr Bounded(double exact) : value(exact) {}
    constexpr Bounded(double computed, double its_error) : value(computed), error(its_error) {}

    static constexpr double u = 0x1p-53;
    static constexpr double underflow = 0x1p-1021;
    /// Turns the computed sum of a few non-negative terms into an upper bound.
    static constexpr double up(double sum) { return sum * (1 + 0x1p-49); }

    friend constexpr Bounded operator-(Bounded a) { return {-a.value, a.error}; }

    // A sum or difference that underflows is exact.
    friend Bounded operator+(Bounded a, Bounded b) {
        // Your turn: the sum, and how far it may be off
        return not_written<Bounded>("Bounded + Bounded");
    }
    friend Bounded operator-(Bounded a, Bounded b) { return a + -b; }

    friend Bounded operator*(Bounded a, Bounded b) {
        // Your turn: the product, and how far it may be off
        return not_written<Bounded>("Bounded * Bounded");
    }

    friend Bounded operator/(Bounded a, Bounded b) {
        if (is_exactly_zero(a) && std::abs(b.value) > b.error) return {};
        const double v = a.value / b.value;
        const double least = (std::abs(b.value) - b.error) * (1 - 0x1p-50);
        if (!(least > 0)) return {v, std::numeric_limits<double>::infinity()};
        // |a/b − v'| ≤ (a.error + |v'| b.error) / least, v' the quotient before rounding, |v'| ≤ |v|(1 + 2u) +
        // underflow. Errors are divided first: a small b.error times a small v' would be lost to underflow.
        return {v, up(a.error / least + up(std::abs(v) + underflow) * (b.error / least) + u * std::abs(v)) + underflow};
    }

    /// Covers the part of the interval that has a root. A true number below it has none, and no caller uses one.
    friend Bounded sqrt(Bounded a) {
        if (!(a.value > 0)) return {0, up(std::sqrt(up(std::abs(a.value) + a.error))) + underflow};
        const double v = std::sqrt(a.value);
        // |√x − √a| = |x − a| / (√x + √a), which is at most |x − a| / √a, and at most √|x − a|.
        return {v, up(std::fmin(a.error / v, std::sqrt(a.error)) + u * v) + underflow};
    }

    friend constexpr Bounded abs(Bounded a) { return {a.value < 0 ? -a.value : a.value, a.error}; }

    friend Kleene operator<(Bounded a, Bounded b) {
        // Your turn: yes, no or undecided
        return not_written<Kleene>("Bounded < Bounded");
    }
    friend Kleene operator>(Bounded a, Bounded b) { return b < a; }
    friend Kleene operator<=(Bounded a, Bounded b) { return !(b < a); }
    friend Kleene operator>=(Bounded a, Bounded b) { return !(a < b); }
    friend Kleene operator!=(Bounded a, Bounded b) {
        if (is_known(a) && is_known(b) && a.error == 0 && b.error == 0) return a.value != b.value;
        const Kleene below = a < b, above = b < a;
        return surely(below) || surely(above) ? Kleene(true) : Kleene::undecided();
    }
    friend Kleene operator==(Bounded a, Bounded b) { return !(a != b); }

    /// False after an overflow, or a division by a number that may be 0.
    friend constexpr bool is_known(Bounded a) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        return a.error < infinity && a.value < infinity && a.value > -infinity;
    }

private:
    static constexpr bool is_exactly_zero(Bounded a) { return a.value == 0 && a.error == 0; }
};

}  // namespace glassbox
