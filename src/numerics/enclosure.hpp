#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <bounded.hpp>

namespace glassbox {

/// Every number that a formula may come to in the scalar Real, however its operations are rounded: each to within a
/// whole unit in the last place, so that fused operations and other modes of rounding are covered, too. The true number
/// is among them. Inputs are the doubles of a scene, rounded to Real.
///
/// Where operands and result are exact in Real, no rounding takes place, and none is assumed: what is 0 stays 0.
template <class Real>
class Enclosure {
public:
    constexpr Enclosure() = default;
    constexpr Enclosure(int number) : range_(static_cast<double>(number)) {}
    explicit Enclosure(double input) : range_(input, is_held(input) ? 0 : rounding(input)) {}
    /// All numbers within that range, rounded or not.
    explicit constexpr Enclosure(Bounded range) : range_(range) {}

    /// The middle, and how far all of them are from it at most; infinite where nothing is known.
    const Bounded& range() const { return range_; }

    friend Enclosure operator-(Enclosure a) { return Enclosure(-a.range_); }

    friend Enclosure operator+(Enclosure a, Enclosure b) {
        if (a.is_zero()) return b;
        if (b.is_zero()) return a;
        const double x = a.range_.value, y = b.range_.value, sum = x + y, part = sum - x;
        if (are_exact(a, b) && is_held(sum) && (x - (sum - part)) + (y - part) == 0) return Enclosure(Bounded(sum));
        return rounded(a.range_ + b.range_);
    }
    friend Enclosure operator-(Enclosure a, Enclosure b) { return a + -b; }

    friend Enclosure operator*(Enclosure a, Enclosure b) {
        if (a.is_zero() || b.is_zero()) return {};
        if (b.is_one()) return a;
        const double product = a.range_.value * b.range_.value;
        if (are_exact(a, b) && is_held(product) && is_ordinary(product) &&
            std::fma(a.range_.value, b.range_.value, -product) == 0)
            return Enclosure(Bounded(product));
        return rounded(a.range_ * b.range_);
    }

    friend Enclosure operator/(Enclosure a, Enclosure b) {
        if (b.is_one() || (a.is_zero() && std::abs(b.range_.value) > b.range_.error)) return a;
        const double quotient = a.range_.value / b.range_.value;
        if (are_exact(a, b) && is_held(quotient) && is_ordinary(a.range_.value) &&
            std::fma(quotient, b.range_.value, -a.range_.value) == 0)
            return Enclosure(Bounded(quotient));
        return rounded(a.range_ / b.range_);
    }

    friend Enclosure sqrt(Enclosure a) {
        const double x = a.range_.value, root = std::sqrt(x);
        if (a.is_zero()) return a;
        if (a.range_.error == 0 && is_held(root) && is_ordinary(x) && std::fma(root, root, -x) == 0)
            return Enclosure(Bounded(root));
        return rounded(sqrt(a.range_));
    }

    friend Enclosure abs(Enclosure a) { return Enclosure(abs(a.range_)); }

    /// x^y for x ≥ 0 and y ≥ 0, which rises or falls with each of them alone: it is largest and least at their ends.
    friend Enclosure pow(Enclosure x, Enclosure y) {
        const auto ends = [](const Bounded& r) {
            return std::pair(std::max(0.0, r.value - r.error), Bounded::up(r.value + r.error));
        };
        const auto [x0, x1] = ends(x.range_);
        const auto [y0, y1] = ends(y.range_);
        const auto [least, most] =
            std::minmax({std::pow(x0, y0), std::pow(x0, y1), std::pow(x1, y0), std::pow(x1, y1)});
        return by_library({(least + most) / 2, Bounded::up((most - least) / 2)});
    }

    friend Enclosure sin(Enclosure a) { return by_library({std::sin(a.range_.value), a.range_.error}); }
    friend Enclosure cos(Enclosure a) { return by_library({std::cos(a.range_.value), a.range_.error}); }
    /// The slope, 1 + tan², is at most doubled within so small a range.
    friend Enclosure tan(Enclosure a) {
        const double value = std::tan(a.range_.value), slope = 1 + value * value;
        if (!(a.range_.error * slope < 0.1)) return Enclosure(Bounded(value, infinity));
        return by_library({value, Bounded::up(2 * a.range_.error * slope)});
    }
    /// The rest is exact, but for what a was off.
    friend Enclosure remquo(Enclosure a, Enclosure b, int* quotient) {
        return Enclosure(Bounded(std::remquo(a.range_.value, b.range_.value, quotient), a.range_.error));
    }

    friend bool isfinite(Enclosure a) { return is_known(a.range_); }

    friend Kleene operator<(Enclosure a, Enclosure b) { return a.range_ < b.range_; }
    friend Kleene operator>(Enclosure a, Enclosure b) { return a.range_ > b.range_; }
    friend Kleene operator<=(Enclosure a, Enclosure b) { return a.range_ <= b.range_; }
    friend Kleene operator>=(Enclosure a, Enclosure b) { return a.range_ >= b.range_; }
    friend constexpr Kleene operator==(Enclosure a, Enclosure b) { return a.range_ == b.range_; }
    friend Kleene operator!=(Enclosure a, Enclosure b) { return a.range_ != b.range_; }

private:
    using Limits = std::numeric_limits<Real>;
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    static constexpr double unit = static_cast<double>(Limits::epsilon());
    /// What underflow may add: of double, as Bounded has it, as subnormal numbers are slow.
    static constexpr double underflow = std::max(static_cast<double>(Limits::denorm_min()), Bounded::underflow);

    bool is_zero() const { return range_.value == 0 && range_.error == 0; }
    bool is_one() const { return range_.value == 1 && range_.error == 0; }
    static bool are_exact(const Enclosure& a, const Enclosure& b) { return a.range_.error == 0 && b.range_.error == 0; }
    /// So large that the rest of an operation does not underflow.
    static bool is_ordinary(double number) { return std::abs(number) > 0x1p-900; }
    static bool is_held(double number) {
        return std::isfinite(number) && static_cast<double>(static_cast<Real>(number)) == number;
    }
    static double rounding(double largest) {
        if (!(std::abs(largest) < static_cast<double>(Limits::max()))) return infinity;
        return Bounded::up(unit * std::abs(largest)) + underflow;
    }

    static Enclosure rounded(Bounded range) {
        const double error = Bounded::up(range.error + rounding(Bounded::up(std::abs(range.value) + range.error)));
        return Enclosure(Bounded(range.value, std::isnan(error) ? infinity : error));
    }
    /// A function of the C library, ours or theirs, is off by a few units in the last place.
    static Enclosure by_library(Bounded range) {
        Enclosure result(range);
        for (int units = 0; units < 4; ++units) result = rounded(result.range_);
        return result;
    }

    Bounded range_;
};

}  // namespace glassbox

/// For formulas with π in them.
template <class Real>
inline constexpr glassbox::Enclosure<Real> std::numbers::pi_v<glassbox::Enclosure<Real>>{
    glassbox::Bounded(std::numbers::pi, static_cast<double>(std::numeric_limits<Real>::epsilon()) * 4)};
