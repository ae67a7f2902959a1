#pragma once
#include <cmath>
#include <limits>

#include <bounded.hpp>
#include <kleene.hpp>

#include "numerics/two_sum.hpp"

namespace glassbox {

/// A number as the sum of two doubles, about 106 binary digits, with a bound on its error: |true − (high + low)| ≤
/// error, guaranteed through every operation, like Bounded, at some five times its cost: a hundredth of what exact
/// arithmetic takes. What doubles leave open it nearly always decides.
///
/// What a sum of doubles lacks is a double itself (Knuth), and so is what a product lacks (Dekker; here by std::fma).
/// The parts that come to it are rounded, each by at most u of itself, u = 2⁻⁵³; those are added to the bound. See
/// Joldes, Muller and Popescu, "Tight and rigorous error bounds for basic building blocks of double-word arithmetic"
/// (2017).
class BoundedPair {
public:
    BoundedPair() = default;
    explicit BoundedPair(double exact) : high_(exact) {}

    /// As near as a double can say it.
    Bounded to_bounded() const { return {high_, Bounded::up(std::abs(low_) + error_)}; }

    friend BoundedPair operator-(const BoundedPair& a) { return {-a.high_, -a.low_, a.error_}; }

    friend BoundedPair operator+(const BoundedPair& a, const BoundedPair& b) {
        const double sum = a.high_ + b.high_, lows = a.low_ + b.low_;
        const double rest = lost_in_sum(a.high_, b.high_, sum) + lows;
        return pair(sum, rest, a.error_ + b.error_ + u * (std::abs(lows) + std::abs(rest)));
    }
    friend BoundedPair operator-(const BoundedPair& a, const BoundedPair& b) { return a + -b; }

    friend BoundedPair operator*(const BoundedPair& a, const BoundedPair& b) {
        if (a.is_exactly_zero() || b.is_exactly_zero()) return {};
        if (b.is_a_double()) return a.times(b.high_);
        if (a.is_a_double()) return b.times(a.high_);
        const double product = a.high_ * b.high_;
        const double first = a.high_ * b.low_, second = a.low_ * b.high_, middle = first + second;
        const double rest = std::fma(a.high_, b.high_, -product) + middle;
        const double rounding =
            u * (std::abs(first) + std::abs(second) + std::abs(middle) + std::abs(rest)) + std::abs(a.low_ * b.low_);
        const double inherited = a.size() * b.error_ + b.size() * a.error_ + a.error_ * b.error_;
        return pair(product, rest, Bounded::up(inherited + rounding) + Bounded::underflow);
    }

    /// Two steps of division; what is left of a − qb then, over the least that b may be, is the error.
    friend BoundedPair operator/(const BoundedPair& a, const BoundedPair& b) {
        const double least = (std::abs(b.high_) - Bounded::up(std::abs(b.low_) + b.error_)) * (1 - 0x1p-50);
        const double first = a.high_ / b.high_;
        if (!(least > 0) || !std::isfinite(first)) return unknown();
        const double second = (a - BoundedPair(first) * b).high_ / b.high_;
        const BoundedPair quotient = pair(first, second, 0);
        const BoundedPair left = a - quotient * b;
        return {quotient.high_, quotient.low_,
                Bounded::up(Bounded::up(left.size() + left.error_) / least) + Bounded::underflow};
    }

    /// Covers the part of the interval that has a root. A true number below it has none, and no caller uses one.
    friend BoundedPair sqrt(const BoundedPair& x) {
        if (!(x.high_ > 0))
            return {0, 0, Bounded::up(std::sqrt(Bounded::up(x.size() + x.error_))) + Bounded::underflow};
        const double first = std::sqrt(x.high_);
        const double second = (x - BoundedPair(first) * BoundedPair(first)).high_ / (2 * first);
        const BoundedPair root = pair(first, second, 0);
        // |√x − q| = |x − q²| / (√x + q), at most |x − q²| / q, and at most √|x − q²|.
        const BoundedPair left = x - root * root;
        const double off = Bounded::up(left.size() + left.error_), least = root.high_ * (1 - 0x1p-50);
        return {root.high_, root.low_, Bounded::up(std::fmin(off / least, std::sqrt(off))) + Bounded::underflow};
    }

    friend BoundedPair abs(const BoundedPair& a) { return a.high_ < 0 ? -a : a; }

    friend Kleene operator<(const BoundedPair& a, const BoundedPair& b) {
        const BoundedPair gap = b - a;
        if (!gap.is_known()) return Kleene::undecided();
        if (gap.error_ == 0) return gap.high_ > 0;
        const double doubt = Bounded::up(std::abs(gap.low_) + gap.error_);
        if (gap.high_ > doubt) return true;
        return gap.high_ < -doubt ? Kleene(false) : Kleene::undecided();
    }
    friend Kleene operator>(const BoundedPair& a, const BoundedPair& b) { return b < a; }
    friend Kleene operator<=(const BoundedPair& a, const BoundedPair& b) { return !(b < a); }
    friend Kleene operator>=(const BoundedPair& a, const BoundedPair& b) { return !(a < b); }
    friend Kleene operator!=(const BoundedPair& a, const BoundedPair& b) {
        const Kleene below = a < b, above = b < a;
        return surely(below) || surely(above)
                   ? Kleene(true)
                   : (!possibly(below) && !possibly(above) ? Kleene(false) : Kleene::undecided());
    }
    friend Kleene operator==(const BoundedPair& a, const BoundedPair& b) { return !(a != b); }

    /// False after an overflow, or a division by a number that may be 0.
    bool is_known() const { return error_ < infinity && std::isfinite(high_) && std::isfinite(low_); }

private:
    BoundedPair(double high, double low, double error) : high_(high), low_(low), error_(error) {}

    static constexpr double u = Bounded::u, infinity = std::numeric_limits<double>::infinity();

    static BoundedPair unknown() { return {0, 0, infinity}; }

    static BoundedPair pair(double large, double small, double error) {
        const double high = large + small;
        return {high, lost_in_sum(large, small, high), error == 0 ? 0 : Bounded::up(error)};
    }

    /// The same as the product of two pairs, where what would be 0 is left out.
    BoundedPair times(double exact) const {
        const double product = high_ * exact, second = low_ * exact, rest = std::fma(high_, exact, -product) + second;
        const double rounding = u * (2 * std::abs(second) + std::abs(rest));
        return pair(product, rest, Bounded::up(Bounded::up(std::abs(exact)) * error_ + rounding) + Bounded::underflow);
    }

    double size() const { return Bounded::up(std::abs(high_) + std::abs(low_)); }
    bool is_a_double() const { return low_ == 0 && error_ == 0; }
    bool is_exactly_zero() const { return high_ == 0 && is_a_double(); }

    double high_ = 0, low_ = 0, error_ = 0;
};

}  // namespace glassbox
