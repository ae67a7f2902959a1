#include "explain/replay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "numerics/bits_lost.hpp"
#include "numerics/exact.hpp"
#include "numerics/graded.hpp"

namespace glassbox {

namespace {

using Long = Dyadic::Long;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// A long float with a bound: the true number is at most `error` away from `value`.
struct LongNumber {
    Long value, error;

    /// Adds the rounding of the result, and of the error itself, to the error.
    static LongNumber rounded(const Long& value, const Long& error) {
        const Long sum = error + ldexp(abs(value), -Dyadic::long_bits);
        return {value, sum + ldexp(sum, 16 - Dyadic::long_bits)};
    }

    friend LongNumber operator-(const LongNumber& a) { return {-a.value, a.error}; }
    friend LongNumber operator+(const LongNumber& a, const LongNumber& b) {
        return rounded(a.value + b.value, a.error + b.error);
    }
    friend LongNumber operator-(const LongNumber& a, const LongNumber& b) { return a + -b; }
    friend LongNumber operator*(const LongNumber& a, const LongNumber& b) {
        return rounded(a.value * b.value, abs(a.value) * b.error + abs(b.value) * a.error + a.error * b.error);
    }
    /// b must surely not be 0. |a/b − a'/b'| ≤ (|a − a'| + |a/b| |b − b'|) / |b'|.
    friend LongNumber operator/(const LongNumber& a, const LongNumber& b) {
        const LongNumber quotient = rounded(a.value / b.value, 0);
        const Long size = abs(quotient.value) + quotient.error;
        return rounded(quotient.value, (a.error + size * b.error) / (abs(b.value) - b.error) + quotient.error);
    }
    /// a must be surely positive. |√a − √a'| = |a − a'| / (√a + √a').
    friend LongNumber sqrt(const LongNumber& a) {
        const Long root = sqrt(a.value);
        return rounded(root, a.error / root);
    }
    friend LongNumber abs(const LongNumber& a) { return {abs(a.value), a.error}; }

    /// None if the error bound includes 0.
    std::optional<int> sign() const {
        if (abs(value) > error) return value.sign();
        return error == 0 ? std::optional(0) : std::nullopt;
    }
};

/// A value without rounding: exact while it needs no more than one square root, then a long float. A long float, too,
/// where too many numbers would have to be multiplied: a loop may square a number again and again.
class True {
public:
    static constexpr int no_root = -1;
    static constexpr int largest = 4096;

    explicit True(Exact exact, int root = no_root, int size = 1) : exact_(std::move(exact)), root_(root), size_(size) {}
    explicit True(LongNumber number) : long_(std::move(number)) {
        if (long_.sign() == 0) exact_ = Exact();
    }

    bool is_exact() const { return exact_.has_value(); }
    const Exact& exact() const { return *exact_; }
    int root() const { return root_; }
    int size() const { return size_; }
    LongNumber to_long() const {
        if (!exact_) return long_;
        const Long value = exact_->to_long();
        return {value, ldexp(abs(value), 8 - Dyadic::long_bits)};  // within a few units of its last place
    }
    /// None if the bits of a long float do not determine it.
    std::optional<int> sign() const { return exact_ ? exact_->sign() : long_.sign(); }

private:
    std::optional<Exact> exact_;
    int root_ = no_root;  ///< the step that took its square root
    int size_ = 1;        ///< how many given numbers it is made of, each as often as it is used
    LongNumber long_;
};

using MaybeTrue = std::optional<True>;

/// Whether Exact can combine both.
bool share_a_root(const True& a, const True& b) {
    return a.is_exact() && b.is_exact() &&
           (a.root() == True::no_root || b.root() == True::no_root || a.root() == b.root());
}

template <class Do>
True combined(const True& a, const True& b, const Do& apply) {
    const int size = a.size() + b.size();
    if (share_a_root(a, b) && size <= True::largest)
        return True(apply(a.exact(), b.exact()), std::max(a.root(), b.root()), size);
    return True(apply(a.to_long(), b.to_long()));
}

/// The sign of a − b, if it is known.
std::optional<int> compared(const True& a, const True& b) {
    if (a.is_exact() && b.is_exact()) return compare(a.exact(), b.exact());
    return (a.to_long() - b.to_long()).sign();
}

/// Whether a comparison holds; of Bounded, as far as their bounds tell.
template <class Number>
auto holds(Operation comparison, const Number& a, const Number& b) {
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

MaybeTrue truth_of(Operation comparison, std::optional<int> order) {
    if (!order) return {};
    return True(Exact(holds(comparison, *order, 0) ? 1.0 : 0.0));
}

/// The square root of a number of 0 or more.
MaybeTrue root_of(const True& a, int step) {
    if (a.is_exact() && a.root() == True::no_root) return True(sqrt(a.exact()), step, a.size());
    if (a.sign() == 0) return a;
    return True(sqrt(a.to_long()));
}

/// Bounds the relative error of a power of long floats: logarithm and exponential are accurate to some hundred units in
/// the last place, and the exponent multiplies the logarithm's error.
Long error_of_power(const Long& base, const Long& exponent) {
    return ldexp(1 + abs(exponent) * (1 + abs(log(base))), 20 - Dyadic::long_bits);
}

/// For a base that is surely positive: with x' = x(1 + d), x'^y = x^y (1 + d)^y, and (1 + d)^y is within 2|y d| of 1
/// where |y d| ≤ 1/2 and |d| ≤ 1/2.
MaybeTrue power(const LongNumber& base, const LongNumber& exponent) {
    const Long value = pow(base.value, exponent.value);
    const Long d = base.error / (base.value - base.error), size = abs(exponent.value) + exponent.error;
    const Long off = size * d + exponent.error * (1 + abs(log(base.value)));
    if (!isfinite(value) || value == 0 || !(off < 0.25) || !(d < 0.5)) return {};
    return True(LongNumber::rounded(value, value * (4 * off + error_of_power(base.value, exponent.value))));
}

/// For a base of 0 or more.
MaybeTrue power(const True& base, const True& exponent) {
    const std::optional<int> sign = base.sign(), exponents = exponent.sign();
    if (!sign || *sign < 0 || !exponents) return {};
    if (*exponents == 0) return True(Exact(1.0));
    if (*sign == 0) return *exponents < 0 ? MaybeTrue{} : MaybeTrue(True(Exact(0.0)));
    return power(base.to_long(), exponent.to_long());
}

MaybeTrue given(long double number) {
    if (!std::isfinite(number)) return {};
    return True(Exact::from(number));
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
            if (!b->sign() || *b->sign() == 0) return {};
            return combined(*a, *b, [](const auto& x, const auto& y) { return x / y; });
        case Operation::negate:
            return a->is_exact() ? True(-a->exact(), a->root(), a->size()) : True(-a->to_long());
        case Operation::absolute:
            return a->is_exact() ? True(abs(a->exact()), a->root(), a->size()) : True(abs(a->to_long()));
        case Operation::square_root:
            if (!a->sign() || *a->sign() < 0) return {};
            return root_of(*a, number);
        case Operation::power:
            return power(*a, *b);
        default:
            return truth_of(step.operation, compared(*a, *b));
    }
}

/// Bounds a power by those of the ends of the base's interval: the power of a base of 0 or more only rises with the
/// base.
Bounded power_within(double value, const Bounded& base, const Bounded& exponent) {
    if (exponent.error != 0 || !(exponent.value >= 0) || !is_known(base) || !(base.value + base.error >= 0))
        return {value, infinity};
    const auto at = [&](const Long& x) { return x.sign() > 0 ? Long(pow(x, Long(exponent.value))) : Long(0); };
    const Long most = at(Long(base.value) + base.error), least = at(Long(base.value) - base.error);
    Long off = std::max(Long(abs(most - value)), Long(abs(least - value)));
    if (most > 0) off += most * error_of_power(Long(base.value) + base.error, Long(exponent.value));
    return {value, Bounded::up(static_cast<double>(off)) + Bounded::underflow};
}

/// 0 if the bounds prove the recorded answer, else 1.
double doubt(const Kleene& truth, bool recorded) { return (recorded ? surely(truth) : !possibly(truth)) ? 0.0 : 1.0; }

/// What the scalar itself makes of the operation; none for a power, which not every scalar has, and for what is no
/// arithmetic.
template <class Number>
std::optional<Number> arithmetic(Operation operation, const Number& a, const Number& b) {
    using std::abs, std::sqrt;
    switch (operation) {
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
        default:
            return {};
    }
}

Bounded bound_of(const Step& step, const Bounded& a, const Bounded& b) {
    const auto value = static_cast<double>(step.value);
    if (const std::optional<Bounded> result = arithmetic(step.operation, a, b)) return *result;
    switch (step.operation) {
        case Operation::input:
        case Operation::constant:
            return Bounded(value);
        case Operation::round:
            return a;
        case Operation::power:
            return power_within(value, a, b);
        default:
            return {value, doubt(holds(step.operation, a, b), step.value != 0)};
    }
}

/// What a long double adds to the bound about its nearest double.
double beyond_double(long double recorded) {
    if (!std::isfinite(recorded)) return 0;
    const long double rest = std::abs(recorded - static_cast<long double>(static_cast<double>(recorded)));
    return rest == 0 ? 0.0 : Bounded::up(static_cast<double>(rest)) + Bounded::underflow;
}

double lost(long double number, const Long& distance, const Precision& precision) {
    return std::min(bits_lost(number, distance, precision), double(precision.digits));
}

/// |truth − number| for a finite number; 0 if a long float cannot tell the two apart.
Long distance_to(const True& truth, long double number) {
    if (truth.is_exact()) return distance(number, truth.exact());
    const LongNumber off = truth.to_long() - LongNumber{Long(number), 0};
    return off.sign() ? Long(abs(off.value)) : Long(0);
}

/// Checks a number whose true value is known; leaves the error bound to the caller.
Checked checked(long double recorded, const True& truth, const Precision& precision) {
    Checked result{.value = static_cast<double>(recorded), .recorded = recorded};
    result.known = truth.is_exact() ? Known::exactly : Known::to_long_float;
    const std::optional<int> sign = truth.sign();
    result.sign = sign.value_or(0);
    result.truth = sign ? static_cast<double>(truth.to_long().value) : 0.0;
    if (!std::isfinite(recorded)) {
        result.distance = infinity;
        result.bits_lost = precision.digits;
        return result;
    }
    const Long distance = distance_to(truth, recorded);
    result.distance = static_cast<double>(distance);
    // A true value too small for the scalar is lost completely, though it is off by less than a unit in the last place.
    result.bits_lost = !sign                         ? not_a_number
                       : recorded == 0 && *sign != 0 ? precision.digits
                                                     : lost(recorded, distance, precision);
    return result;
}

Checked checked(const Step& step, const Bounded& bound, const MaybeTrue& truth, const Precision& precision) {
    Checked result;
    if (truth) result = checked(step.value, *truth, precision);
    else
        result = {.value = static_cast<double>(step.value),
                  .recorded = step.value,
                  .error = infinity,
                  .truth = not_a_number,
                  .distance = not_a_number,
                  .bits_lost = not_a_number,
                  .known = Known::not_at_all};
    const bool compares = is_comparison(step.operation);
    if (!truth && !compares) return result;  // without a true value there is no bound
    if (truth && compares) result.bits_lost = 0;
    const double beyond = beyond_double(step.value);
    result.error = beyond == 0 ? bound.error : Bounded::up(bound.error + beyond);
    return result;
}

/// Calls `use` with 0 in the scalar of that precision.
template <class Use>
auto in_scalar(const Precision& precision, const Use& use) {
    if (precision == Precision::of<float>()) return use(0.f);
    if (precision == Precision::of<double>()) return use(0.0);
    return use(0.0L);
}

/// The scalar's number that is nearest to a true value, whose step has been checked; none if its sign is not known.
std::optional<long double> nearest(const MaybeTrue& truth, const Checked& number, const Precision& precision) {
    if (!truth || !truth->sign()) return {};
    if (truth->is_exact() && number.distance == 0 && number.bits_lost == 0) return number.recorded;
    const Long value = truth->to_long().value;
    return in_scalar(precision, [&]<class Real>(Real) { return static_cast<long double>(static_cast<Real>(value)); });
}

/// What the scalar makes of the operation, if not a comparison, on these operands.
long double computed(Operation operation, long double left, long double right, const Precision& precision) {
    return in_scalar(precision, [&]<class Real>(Real) -> long double {
        const auto a = static_cast<Real>(left), b = static_cast<Real>(right);
        if (operation == Operation::power) return std::pow(a, b);
        return arithmetic(operation, a, b).value_or(a);  // else rounded to the scalar
    });
}

/// How many of a number's bits are lost at the distance of another one.
double bits_between(long double number, long double other, const Precision& precision) {
    if (number == other) return 0;
    if (!std::isfinite(number) || !std::isfinite(other) || number == 0) return precision.digits;
    return lost(number, abs(Long(number) - Long(other)), precision);
}

/// Tells the own loss from the inherited one. `left` and `right` are the nearest numbers to the true operands, `a` and
/// `b` the computed ones.
void tell_losses(Checked& told, const Step& step, const MaybeTrue& truth, std::optional<long double> left,
                 std::optional<long double> right, long double a, long double b, const Precision& precision) {
    if (!truth || !truth->sign() || !left || !right) {
        told.own_loss = told.inherited_loss = not_a_number;
    } else if (*left == a && *right == b) {
        told.own_loss = told.bits_lost;
    } else {
        const long double best = computed(step.operation, *left, *right, precision);
        told.own_loss = checked(best, *truth, precision).bits_lost;
        told.inherited_loss = bits_between(step.value, best, precision);
    }
}

}  // namespace

std::vector<Checked> replay(const Tape& tape) {
    std::vector<Checked> all;
    std::vector<Bounded> bounds;
    std::vector<MaybeTrue> truths;
    std::vector<std::optional<long double>> best;  // the nearest numbers to the truths
    all.reserve(tape.steps().size());
    bounds.reserve(tape.steps().size());
    truths.reserve(tape.steps().size());
    best.reserve(tape.steps().size());
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
        best.push_back(nearest(truths.back(), all.back(), tape.precision()));
        if (starts || is_comparison(step.operation)) continue;
        tell_losses(all.back(), step, truths.back(), best[step.left], best[step.right], tape[step.left].value,
                    tape[step.right].value, tape.precision());
    }
    return all;
}

Checked checked(double value, const Exact& truth) {
    Checked result = checked(static_cast<long double>(value), True(truth), Precision::of<double>());
    if (result.distance == 0 && result.bits_lost == 0) return result;
    result.error = Bounded::up(result.distance) + Bounded::underflow;
    return result;
}

}  // namespace glassbox
