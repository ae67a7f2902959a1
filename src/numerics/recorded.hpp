#pragma once
#include <cassert>
#include <cmath>
#include <concepts>
#include <string>
#include <type_traits>
#include <utility>

#include <vec3.hpp>

#include "numerics/tape.hpp"

namespace glassbox {

template <class Real>
class Operand;

/// The result of comparing two recorded numbers: a bool in a type of its own, because compilers take `&` between two
/// calls that write to a tape for a mistyped `&&`.
struct RecordedTruth {
    bool truth = false;

    constexpr RecordedTruth(bool value) : truth(value) {}
    constexpr operator bool() const { return truth; }
    friend constexpr RecordedTruth operator&(RecordedTruth a, RecordedTruth b) { return a.truth && b.truth; }
};

/// A float, double or long double that records how it was computed: each operation appends a step to its tape, with the
/// operands, the result and the source line. Results equal the scalar's own, bit for bit, and comparisons answer as the
/// scalar's would, so a formula takes the same branches as in the picture.
///
/// Numbers without a tape are constants. The tape must outlive its numbers.
template <class Real>
class Recorded {
public:
    using Last = Operand<Real>;

    constexpr Recorded() = default;
    template <class Number>
    requires std::is_arithmetic_v<Number>
    constexpr Recorded(Number constant) : value_(static_cast<Real>(constant)) {}

    /// A named input. If the scalar cannot hold it, its rounding is a step, too.
    static Recorded input(Tape& tape, double value, const std::string& name) {
        assert(tape.precision() == Precision::of<Real>());
        const StepNumber given = tape.append({.operation = Operation::input, .value = value});
        tape.name(given, name);
        const auto rounded = static_cast<Real>(value);
        if (!(static_cast<double>(rounded) < value || static_cast<double>(rounded) > value))
            return {rounded, &tape, given};
        const StepNumber step = tape.append({Operation::round, given, given, rounded});
        tape.name(step, name);
        return {rounded, &tape, step};
    }

    Real value() const { return value_; }
    /// Null for a constant.
    Tape* tape() const { return tape_; }
    StepNumber step() const { return step_; }

    template <class Number>
    requires std::is_arithmetic_v<Number>
    explicit operator Number() const { return static_cast<Number>(value_); }

    friend Recorded operator+(const Recorded& a, const Last& b) {
        return b.result(a, Operation::add, a.value_ + b.value());
    }
    friend Recorded operator-(const Recorded& a, const Last& b) {
        return b.result(a, Operation::subtract, a.value_ - b.value());
    }
    friend Recorded operator*(const Recorded& a, const Last& b) {
        return b.result(a, Operation::multiply, a.value_ * b.value());
    }
    friend Recorded operator/(const Recorded& a, const Last& b) {
        return b.result(a, Operation::divide, a.value_ / b.value());
    }
    friend Recorded operator-(const Last& a) { return a.result(Operation::negate, -a.value()); }
    friend Recorded sqrt(const Last& a) { return a.result(Operation::square_root, std::sqrt(a.value())); }
    friend Recorded abs(const Last& a) { return a.result(Operation::absolute, std::abs(a.value())); }
    friend Recorded pow(const Recorded& a, const Last& b) {
        return b.result(a, Operation::power, std::pow(a.value_, b.value()));
    }

    /// Not a step: formulas ask it only about numbers too large to continue with.
    friend bool isfinite(const Recorded& a) { return std::isfinite(a.value_); }

    friend RecordedTruth operator<(const Recorded& a, const Last& b) {
        return b.compared(a, Operation::less, a.value_ < b.value());
    }
    friend RecordedTruth operator>(const Recorded& a, const Last& b) {
        return b.compared(a, Operation::greater, a.value_ > b.value());
    }
    friend RecordedTruth operator<=(const Recorded& a, const Last& b) {
        return b.compared(a, Operation::less_equal, a.value_ <= b.value());
    }
    friend RecordedTruth operator>=(const Recorded& a, const Last& b) {
        return b.compared(a, Operation::greater_equal, a.value_ >= b.value());
    }
    friend RecordedTruth operator==(const Last& a, const Last& b) {
        return b.compared(a, Operation::equal, a.value() == b.value());
    }
    friend RecordedTruth operator!=(const Last& a, const Last& b) {
        return b.compared(a, Operation::not_equal, a.value() != b.value());
    }

private:
    friend Last;
    constexpr Recorded(Real value, Tape* tape, StepNumber step) : value_(value), tape_(tape), step_(step) {}

    /// The number's step on a tape; appends a constant first.
    StepNumber step_on(Tape& tape) const {
        return tape_ ? step_ : tape.append({.operation = Operation::constant, .value = value_});
    }

    Real value_ = 0;
    Tape* tape_ = nullptr;
    StepNumber step_ = 0;
};

/// The last operand of an operation. It is constructed where the operation is written, and so knows the file and the
/// line.
template <class Real>
class Operand {
public:
    // std::source_location is built on __builtin_FILE and __builtin_LINE; not all our compilers have it.
    template <class Number>
    requires std::is_arithmetic_v<Number> || std::same_as<Number, Recorded<Real>> Operand(
        const Number& number, const char* file = __builtin_FILE(), int line = __builtin_LINE())
        : number_(number), file_(file), line_(line) {}

    Real value() const { return number_.value_; }

    /// The result of an operation with this operand alone.
    Recorded<Real> result(Operation operation, Real value) const {
        Tape* const tape = number_.tape_;
        if (!tape) return value;
        return {value, tape, tape->append({operation, number_.step_, number_.step_, value, file_, line_})};
    }

    /// The result of an operation with another operand before it.
    Recorded<Real> result(const Recorded<Real>& left, Operation operation, Real value) const {
        Tape* const tape = left.tape_ ? left.tape_ : number_.tape_;
        if (!tape) return value;
        const StepNumber a = left.step_on(*tape), b = number_.step_on(*tape);
        return {value, tape, tape->append({operation, a, b, value, file_, line_})};
    }

    RecordedTruth compared(const Recorded<Real>& left, Operation operation, bool truth) const {
        result(left, operation, truth ? Real(1) : Real(0));
        return truth;
    }
    RecordedTruth compared(const Operand& left, Operation operation, bool truth) const {
        return compared(left.number_, operation, truth);
    }

private:
    Recorded<Real> number_;
    const char* file_;
    int line_;
};

/// A vector of inputs: "P" gives "P.x", "P.y" and "P.z".
template <class Real>
Vec3<Recorded<Real>> input(Tape& tape, const Vec3<double>& v, const std::string& name) {
    using Number = Recorded<Real>;
    return {Number::input(tape, v.x, name + ".x"), Number::input(tape, v.y, name + ".y"),
            Number::input(tape, v.z, name + ".z")};
}

/// Names a number that a formula reports.
template <class Real>
void name(const Recorded<Real>& number, std::string name) {
    if (number.tape()) number.tape()->name(number.step(), std::move(name));
}
template <class Real>
void name(const Vec3<Recorded<Real>>& v, const std::string& its_name) {
    name(v.x, its_name + ".x");
    name(v.y, its_name + ".y");
    name(v.z, its_name + ".z");
}

}  // namespace glassbox

#include "numerics/recorded_calls.hpp"  // whoever computes with recorded numbers notes their calls
