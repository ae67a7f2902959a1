#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include <bounded.hpp>

namespace glassbox {

/// The answer of a comparison, and how sure it is: the compared numbers' distance over the bound on its error. Above 1
/// the answer is the true one, and stays so for whatever the errors are; infinite where nothing was rounded.
///
/// Answers are combined as their truths are: of two that are both needed the less sure one counts, of two that are each
/// enough the surer one.
struct GradedTruth {
    bool holds = false;
    double sureness = std::numeric_limits<double>::infinity();

    constexpr GradedTruth(bool truth) : holds(truth) {}
    constexpr GradedTruth(bool truth, double how_sure) : holds(truth), sureness(how_sure) {}

    constexpr bool is_decided() const { return sureness > 1; }

    friend constexpr bool surely(GradedTruth a) { return a.holds && a.is_decided(); }
    /// Always: a formula that stopped at the first "no" would not tell how sure its answer is.
    friend constexpr bool possibly(GradedTruth) { return true; }

    friend constexpr GradedTruth operator!(GradedTruth a) { return {!a.holds, a.sureness}; }
    friend constexpr GradedTruth operator&(GradedTruth a, GradedTruth b) {
        if (a.holds != b.holds) return a.holds ? b : a;
        return {a.holds, a.holds ? std::min(a.sureness, b.sureness) : std::max(a.sureness, b.sureness)};
    }
    friend constexpr GradedTruth operator&&(GradedTruth a, GradedTruth b) { return a & b; }
    friend constexpr GradedTruth operator|(GradedTruth a, GradedTruth b) { return !((!a) & (!b)); }
    friend constexpr GradedTruth operator!=(GradedTruth a, GradedTruth b) {
        return {a.holds != b.holds, std::min(a.sureness, b.sureness)};
    }
};

/// The bound about the number that was recorded, which may differ from the bound's own: a float was rounded again, a
/// long double less, and 0 times infinity is NaN.
inline Bounded about(double recorded, const Bounded& bound) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (bound.value == recorded) return {recorded, std::isnan(bound.error) ? infinity : bound.error};
    const double error = Bounded::up(bound.error + std::abs(bound.value - recorded));
    return {recorded, std::isnan(error) ? infinity : error};
}

/// The distance of two bounded numbers over the bound on its error: above 1 their order is proven. 0 where nothing is
/// known of one.
inline double sureness_of_order(const Bounded& a, const Bounded& b) {
    if (!is_known(a) || !is_known(b)) return 0;
    if (a.error == 0 && b.error == 0) return std::numeric_limits<double>::infinity();
    const double gap = std::abs(a.value - b.value);
    if (!std::isfinite(gap)) return 0;
    const double rounding = a.value == 0 || b.value == 0 ? 0 : Bounded::u * gap;  // of the gap
    return gap / Bounded::up(a.error + b.error + rounding);
}

/// A float, double or long double with a guaranteed bound on its error, whose comparisons answer as the scalar's own
/// do, and say how sure they are.
template <class Real>
class Graded {
public:
    constexpr Graded() = default;
    template <class Number>
    requires std::is_arithmetic_v<Number>
    explicit Graded(Number given) : Graded(static_cast<Real>(given), Bounded(static_cast<double>(given))) {}

    Real value() const { return value_; }
    /// About the value, rounded to a double.
    const Bounded& bound() const { return bound_; }
    /// The same number with nothing known of it.
    Graded unbounded() const { return {value_, Bounded(0, std::numeric_limits<double>::infinity())}; }

    friend Graded operator-(const Graded& a) { return {-a.value_, -a.bound_}; }
    friend Graded operator+(const Graded& a, const Graded& b) { return {a.value_ + b.value_, a.bound_ + b.bound_}; }
    friend Graded operator-(const Graded& a, const Graded& b) { return {a.value_ - b.value_, a.bound_ - b.bound_}; }
    friend Graded operator*(const Graded& a, const Graded& b) { return {a.value_ * b.value_, a.bound_ * b.bound_}; }
    friend Graded operator/(const Graded& a, const Graded& b) { return {a.value_ / b.value_, a.bound_ / b.bound_}; }
    friend Graded sqrt(const Graded& a) { return {std::sqrt(a.value_), sqrt(a.bound_)}; }
    friend Graded abs(const Graded& a) { return {std::abs(a.value_), abs(a.bound_)}; }

    friend GradedTruth operator<(const Graded& a, const Graded& b) { return graded(a.value_ < b.value_, a, b); }
    friend GradedTruth operator>(const Graded& a, const Graded& b) { return graded(a.value_ > b.value_, a, b); }
    friend GradedTruth operator<=(const Graded& a, const Graded& b) { return graded(a.value_ <= b.value_, a, b); }
    friend GradedTruth operator>=(const Graded& a, const Graded& b) { return graded(a.value_ >= b.value_, a, b); }
    friend GradedTruth operator==(const Graded& a, const Graded& b) { return graded(a.value_ == b.value_, a, b); }
    friend GradedTruth operator!=(const Graded& a, const Graded& b) { return graded(a.value_ != b.value_, a, b); }

private:
    Graded(Real value, const Bounded& bound) : value_(value), bound_(about(static_cast<double>(value), bound)) {}

    static GradedTruth graded(bool holds, const Graded& a, const Graded& b) {
        return {holds, sureness_of_order(a.bound_, b.bound_)};
    }

    Real value_ = 0;
    Bounded bound_;
};

/// As the scalar chooses; where that is not sure, nothing is known of the result.
template <class Real>
Graded<Real> choose(const GradedTruth& condition, const Graded<Real>& a, const Graded<Real>& b) {
    const Graded<Real>& chosen = condition.holds ? a : b;
    return condition.is_decided() ? chosen : chosen.unbounded();
}

}  // namespace glassbox
