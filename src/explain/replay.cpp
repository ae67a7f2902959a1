#include "explain/replay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "numerics/exact.hpp"

namespace glassbox {

namespace {

using Long = Dyadic::Long;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// A value without rounding: exact while it needs no more than one square root, then a long float.
class True {
public:
    static constexpr int no_root = -1;

    explicit True(Exact exact, int root = no_root) : exact_(std::move(exact)), root_(root) {}
    explicit True(Long number) : long_(std::move(number)) {}

    bool is_exact() const { return exact_.has_value(); }
    const Exact& exact() const { return *exact_; }
    int root() const { return root_; }
    Long to_long() const { return exact_ ? exact_->to_long() : long_; }
    int sign() const { return exact_ ? exact_->sign() : long_.sign(); }

private:
    std::optional<Exact> exact_;
    int root_ = no_root;  ///< the step that took the square root in it
    Long long_;
};

using MaybeTrue = std::optional<True>;

/// Whether Exact can compute with both at once.
bool share_a_root(const True& a, const True& b) {
    return a.is_exact() && b.is_exact() &&
           (a.root() == True::no_root || b.root() == True::no_root || a.root() == b.root());
}

template <class Do>
True combined(const True& a, const True& b, const Do& apply) {
    if (share_a_root(a, b)) return True(apply(a.exact(), b.exact()), std::max(a.root(), b.root()));
    return True(apply(a.to_long(), b.to_long()));
}

int compared(const True& a, const True& b) {
    if (a.is_exact() && b.is_exact()) return compare(a.exact(), b.exact());
    return a.to_long().compare(b.to_long());
}

bool holds(Operation comparison, int order) {
    switch (comparison) {
        case Operation::less:
            return order < 0;
        case Operation::greater:
            return order > 0;
        case Operation::less_equal:
            return order <= 0;
        case Operation::greater_equal:
            return order >= 0;
        case Operation::equal:
            return order == 0;
        default:
            return order != 0;
    }
}

True root_of(const True& a, int step) {
    if (a.is_exact() && a.root() == True::no_root) return True(sqrt(a.exact()), step);
    return True(sqrt(a.to_long()));
}

/// For a base of 0 or more.
MaybeTrue power(const True& base, const True& exponent) {
    if (base.sign() < 0) return {};
    if (base.sign() == 0 && exponent.sign() <= 0)
        return exponent.sign() < 0 ? MaybeTrue{} : MaybeTrue(True(Exact(1.0)));
    if (base.sign() == 0) return True(Exact(0.0));
    return True(pow(base.to_long(), exponent.to_long()));
}

/// A finite number as the sum of doubles; nothing where it is beyond their range, as a long double may be.
std::optional<Exact> exactly(long double number) {
    Exact sum;
    while (number != 0) {
        const auto head = static_cast<double>(number);
        if (head == 0 || !std::isfinite(head)) return {};
        sum = sum + Exact(head);
        number -= head;
    }
    return sum;
}

MaybeTrue given(long double number) {
    if (!std::isfinite(number)) return {};
    const std::optional<Exact> exact = exactly(number);
    return exact ? True(*exact) : True(Long(number));
}

MaybeTrue truth_of(const Step& step, int number, const MaybeTrue& a, const MaybeTrue& b) {
    if (operands(step.operation) == 0) return given(step.value);
    if (!a || !b) return {};
    switch (step.operation) {
        case Operation::round:
            return a;
        case Operation::add:
            return combined(*a, *b, [](const auto& x, const auto& y) { return x + y; });
        case Operation::subtract:
            return combined(*a, *b, [](const auto& x, const auto& y) { return x - y; });
        case Operation::multiply:
            return combined(*a, *b, [](const auto& x, const auto& y) { return x * y; });
        case Operation::divide:
            if (b->sign() == 0) return {};
            return combined(*a, *b, [](const auto& x, const auto& y) { return x / y; });
        case Operation::negate:
            return a->is_exact() ? True(-a->exact(), a->root()) : True(-a->to_long());
        case Operation::absolute:
            return a->is_exact() ? True(abs(a->exact()), a->root()) : True(abs(a->to_long()));
        case Operation::square_root:
            if (a->sign() < 0) return {};
            return root_of(*a, number);
        case Operation::power:
            return power(*a, *b);
        default:
            return True(Exact(holds(step.operation, compared(*a, *b)) ? 1.0 : 0.0));
    }
}

/// Between the powers of the ends of the base's interval: a power of a base of 0 or more only rises with it.
Bounded power_within(double value, const Bounded& base, const Bounded& exponent) {
    if (exponent.error != 0 || !(exponent.value >= 0) || !is_known(base) || !(base.value + base.error >= 0))
        return {value, infinity};
    const auto at = [&](const Long& x) { return x.sign() > 0 ? Long(pow(x, Long(exponent.value))) : Long(0); };
    const Long most = at(Long(base.value) + base.error), least = at(Long(base.value) - base.error);
    const Long off = std::max(Long(abs(most - value)), Long(abs(least - value))) + ldexp(abs(most), -290);
    return {value, Bounded::up(static_cast<double>(off)) + Bounded::underflow};
}

Kleene truth_within(Operation comparison, const Bounded& a, const Bounded& b) {
    switch (comparison) {
        case Operation::less:
            return a < b;
        case Operation::greater:
            return a > b;
        case Operation::less_equal:
            return a <= b;
        case Operation::greater_equal:
            return a >= b;
        case Operation::equal:
            return a == b;
        default:
            return a != b;
    }
}

/// 0 where the bounds prove what was recorded, else 1.
double doubt(const Kleene& truth, bool recorded) { return (recorded ? surely(truth) : !possibly(truth)) ? 0.0 : 1.0; }

Bounded bound_of(const Step& step, const Bounded& a, const Bounded& b) {
    const auto value = static_cast<double>(step.value);
    switch (step.operation) {
        case Operation::input:
        case Operation::constant:
            return Bounded(value);
        case Operation::round:
            return a;
        case Operation::add:
            return a + b;
        case Operation::subtract:
            return a - b;
        case Operation::multiply:
            return a * b;
        case Operation::divide:
            return a / b;
        case Operation::negate:
            return -a;
        case Operation::absolute:
            return abs(a);
        case Operation::square_root:
            return sqrt(a);
        case Operation::power:
            return power_within(value, a, b);
        default:
            return {value, doubt(truth_within(step.operation, a, b), step.value != 0)};
    }
}

/// The bound about the value that was recorded, where the two have parted: a float was rounded again, a long double
/// less, and 0 times infinity is no number.
Bounded about(double recorded, const Bounded& bound) {
    if (bound.value == recorded) return {recorded, std::isnan(bound.error) ? infinity : bound.error};
    const double error = Bounded::up(bound.error + std::abs(bound.value - recorded));
    return {recorded, std::isnan(error) ? infinity : error};
}

/// What a long double adds to the bound about the nearest double.
double beyond_double(long double recorded) {
    if (!std::isfinite(recorded)) return 0;
    const long double rest = std::abs(recorded - static_cast<long double>(static_cast<double>(recorded)));
    return rest == 0 ? 0.0 : Bounded::up(static_cast<double>(rest)) + Bounded::underflow;
}

/// The exponent of a number's unit in the last place, a power of 2.
int last_place(long double number, const Precision& precision) {
    int exponent = precision.min_exponent;
    if (number != 0) std::frexp(number, &exponent);
    return std::max(exponent, precision.min_exponent) - precision.digits;
}

double bits(const Long& distance, long double number, const Precision& precision) {
    if (distance == 0) return 0;
    const auto ulps = static_cast<double>(Long(ldexp(distance, -last_place(number, precision))));
    return std::min(std::log2(ulps + 1), double(precision.digits));
}

/// |truth − number|, the number finite.
Long distance_to(const True& truth, long double number) {
    const std::optional<Exact> exact = truth.is_exact() ? exactly(number) : std::nullopt;
    return exact ? abs((truth.exact() - *exact).to_long()) : Long(abs(truth.to_long() - Long(number)));
}

Checked checked(const Step& step, const Bounded& bound, const MaybeTrue& truth, const Precision& precision) {
    Checked result{.value = static_cast<double>(step.value), .recorded = step.value, .error = bound.error};
    const double beyond = beyond_double(step.value);
    if (!(beyond == 0)) result.error = Bounded::up(bound.error + beyond);
    if (!truth) {
        result.known = Known::not_at_all;
        result.truth = result.distance = result.bits_lost = not_a_number;
        return result;
    }
    result.known = truth->is_exact() ? Known::exactly : Known::to_long_float;
    result.sign = truth->sign();
    result.truth = static_cast<double>(truth->to_long());
    if (!std::isfinite(step.value)) {
        result.distance = infinity;
        result.bits_lost = precision.digits;
        return result;
    }
    const Long distance = distance_to(*truth, step.value);
    result.distance = static_cast<double>(distance);
    if (is_comparison(step.operation)) return result;
    // A truth too small for the scalar is lost whole, though its distance is less than a unit in the last place.
    result.bits_lost = step.value == 0 && result.sign != 0 ? precision.digits : bits(distance, step.value, precision);
    return result;
}

}  // namespace

std::vector<Checked> replay(const Tape& tape) {
    std::vector<Checked> all;
    std::vector<Bounded> bounds;
    std::vector<MaybeTrue> truths;
    all.reserve(tape.steps().size());
    bounds.reserve(tape.steps().size());
    truths.reserve(tape.steps().size());
    const Bounded no_bound;
    const MaybeTrue no_truth;
    for (const Step& step : tape.steps()) {
        const bool starts = operands(step.operation) == 0;
        const auto number = static_cast<int>(all.size());
        bounds.push_back(about(static_cast<double>(step.value), bound_of(step, starts ? no_bound : bounds[step.left],
                                                                         starts ? no_bound : bounds[step.right])));
        truths.push_back(
            truth_of(step, number, starts ? no_truth : truths[step.left], starts ? no_truth : truths[step.right]));
        all.push_back(checked(step, bounds.back(), truths.back(), tape.precision()));
    }
    return all;
}

Checked checked(double value, const Bounded& truth) {
    const double off = std::abs(value - truth.value);
    const double distance = off == 0 ? truth.error : off;
    return {.value = value,
            .recorded = value,
            .error = Bounded::up(off + truth.error),
            .truth = truth.value,
            .distance = distance,
            .bits_lost = std::isfinite(distance) ? bits(Long(distance), value, Precision::of<double>())
                                                 : double(Precision::of<double>().digits),
            .sign = truth.value > 0   ? 1
                    : truth.value < 0 ? -1
                                      : 0,
            .known = Known::exactly};
}

}  // namespace glassbox
