#pragma once
#include <cmath>
#include <concepts>
#include <string>
#include <type_traits>
#include <utility>

#include <vec3.hpp>

#include "numerics/tape.hpp"

namespace glassbox {

class Operand;

/// What comparing two recorded numbers answers: a bool, of a type of its own because `&` of two calls that write on a
/// tape looks like a mistyped `&&` to a compiler.
struct RecordedTruth {
    bool truth = false;

    constexpr RecordedTruth(bool value) : truth(value) {}
    constexpr operator bool() const { return truth; }
    friend constexpr RecordedTruth operator&(RecordedTruth a, RecordedTruth b) { return a.truth && b.truth; }
};

/// A double that writes down where it comes from: each operation with it becomes a step of its tape, with its operands,
/// its result and the line of source that asked for it. The results are a double's own, bit for bit, and comparisons
/// answer what a double's would, so that a formula goes the same way as in the picture.
///
/// Numbers without a tape are constants. The tape must outlive its numbers.
class Recorded {
public:
    constexpr Recorded() = default;
    template <class Number>
    requires std::is_arithmetic_v<Number>
    constexpr Recorded(Number constant) : value_(static_cast<double>(constant)) {}

    /// A number that comes from outside, by name.
    static Recorded input(Tape& tape, double value, std::string name) {
        const Recorded number(value, &tape, tape.append({.operation = Operation::input, .value = value}));
        tape.name(number.step_, std::move(name));
        return number;
    }

    double value() const { return value_; }
    /// Null for a constant.
    Tape* tape() const { return tape_; }
    StepNumber step() const { return step_; }

    template <class Number>
    requires std::is_arithmetic_v<Number>
    explicit operator Number() const { return static_cast<Number>(value_); }

    friend Recorded operator+(const Recorded& a, const Operand& b);
    friend Recorded operator-(const Recorded& a, const Operand& b);
    friend Recorded operator*(const Recorded& a, const Operand& b);
    friend Recorded operator/(const Recorded& a, const Operand& b);
    friend Recorded operator-(const Operand& a);
    friend Recorded sqrt(const Operand& a);
    friend Recorded abs(const Operand& a);
    friend Recorded pow(const Recorded& a, const Operand& b);

    friend RecordedTruth operator<(const Recorded& a, const Operand& b);
    friend RecordedTruth operator>(const Recorded& a, const Operand& b);
    friend RecordedTruth operator<=(const Recorded& a, const Operand& b);
    friend RecordedTruth operator>=(const Recorded& a, const Operand& b);
    friend RecordedTruth operator==(const Operand& a, const Operand& b);
    friend RecordedTruth operator!=(const Operand& a, const Operand& b);

private:
    friend class Operand;
    constexpr Recorded(double value, Tape* tape, StepNumber step) : value_(value), tape_(tape), step_(step) {}

    /// Where the number stands on a tape: a constant is written down first.
    StepNumber step_on(Tape& tape) const {
        return tape_ ? step_ : tape.append({.operation = Operation::constant, .value = value_});
    }

    double value_ = 0;
    Tape* tape_ = nullptr;
    StepNumber step_ = 0;
};

/// The last operand of an operation. It is made where the operation stands, and so knows the file and the line.
class Operand {
public:
    // __builtin_FILE and __builtin_LINE are what std::source_location stands on; not all our compilers have that.
    template <class Number>
    requires std::is_arithmetic_v<Number> || std::same_as<Number, Recorded> Operand(const Number& number,
                                                                                    const char* file = __builtin_FILE(),
                                                                                    int line = __builtin_LINE())
        : number_(number), file_(file), line_(line) {}

    double value() const { return number_.value_; }

    /// The result of an operation with this operand alone.
    Recorded result(Operation operation, double value) const {
        Tape* const tape = number_.tape_;
        if (!tape) return value;
        return {value, tape, tape->append({operation, number_.step_, number_.step_, value, file_, line_})};
    }

    /// The result of an operation with another operand before it.
    Recorded result(const Recorded& left, Operation operation, double value) const {
        Tape* const tape = left.tape_ ? left.tape_ : number_.tape_;
        if (!tape) return value;
        const StepNumber a = left.step_on(*tape), b = number_.step_on(*tape);
        return {value, tape, tape->append({operation, a, b, value, file_, line_})};
    }

    RecordedTruth compared(const Recorded& left, Operation operation, bool truth) const {
        result(left, operation, truth ? 1 : 0);
        return truth;
    }
    RecordedTruth compared(const Operand& left, Operation operation, bool truth) const {
        return compared(left.number_, operation, truth);
    }

private:
    Recorded number_;
    const char* file_;
    int line_;
};

inline Recorded operator+(const Recorded& a, const Operand& b) {
    return b.result(a, Operation::add, a.value_ + b.value());
}
inline Recorded operator-(const Recorded& a, const Operand& b) {
    return b.result(a, Operation::subtract, a.value_ - b.value());
}
inline Recorded operator*(const Recorded& a, const Operand& b) {
    return b.result(a, Operation::multiply, a.value_ * b.value());
}
inline Recorded operator/(const Recorded& a, const Operand& b) {
    return b.result(a, Operation::divide, a.value_ / b.value());
}
inline Recorded operator-(const Operand& a) { return a.result(Operation::negate, -a.value()); }
inline Recorded sqrt(const Operand& a) { return a.result(Operation::square_root, std::sqrt(a.value())); }
inline Recorded abs(const Operand& a) { return a.result(Operation::absolute, std::abs(a.value())); }
inline Recorded pow(const Recorded& a, const Operand& b) {
    return b.result(a, Operation::power, std::pow(a.value_, b.value()));
}

inline RecordedTruth operator<(const Recorded& a, const Operand& b) {
    return b.compared(a, Operation::less, a.value_ < b.value());
}
inline RecordedTruth operator>(const Recorded& a, const Operand& b) {
    return b.compared(a, Operation::greater, a.value_ > b.value());
}
inline RecordedTruth operator<=(const Recorded& a, const Operand& b) {
    return b.compared(a, Operation::less_equal, a.value_ <= b.value());
}
inline RecordedTruth operator>=(const Recorded& a, const Operand& b) {
    return b.compared(a, Operation::greater_equal, a.value_ >= b.value());
}
inline RecordedTruth operator==(const Operand& a, const Operand& b) {
    return b.compared(a, Operation::equal, a.value() == b.value());
}
inline RecordedTruth operator!=(const Operand& a, const Operand& b) {
    return b.compared(a, Operation::not_equal, a.value() != b.value());
}

/// A vector of inputs: "P" gives "P.x", "P.y" and "P.z".
inline Vec3<Recorded> input(Tape& tape, const Vec3<double>& v, const std::string& name) {
    return {Recorded::input(tape, v.x, name + ".x"), Recorded::input(tape, v.y, name + ".y"),
            Recorded::input(tape, v.z, name + ".z")};
}

/// Gives a number that a formula tells of its name.
inline void name(const Recorded& number, std::string name) {
    if (number.tape()) number.tape()->name(number.step(), std::move(name));
}
inline void name(const Vec3<Recorded>& v, const std::string& its_name) {
    name(v.x, its_name + ".x");
    name(v.y, its_name + ".y");
    name(v.z, its_name + ".z");
}

}  // namespace glassbox
