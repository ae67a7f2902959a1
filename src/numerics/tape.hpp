#pragma once
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace glassbox {

/// What one step of a computation does.
enum class Operation : std::uint8_t {
    input,
    constant,
    round,
    add,
    subtract,
    multiply,
    divide,
    negate,
    square_root,
    power,
    absolute,
    less,
    greater,
    less_equal,
    greater_equal,
    equal,
    not_equal
};

/// How many operands an operation has.
constexpr int operands(Operation operation) {
    switch (operation) {
        case Operation::input:
        case Operation::constant:
            return 0;
        case Operation::round:
        case Operation::negate:
        case Operation::square_root:
        case Operation::absolute:
            return 1;
        default:
            return 2;
    }
}

constexpr bool is_comparison(Operation operation) { return operation >= Operation::less; }

/// A step of a tape, counted from its start.
using StepNumber = std::uint32_t;

/// A scalar's precision: `digits` bits, the same for all numbers of size 2^min_exponent / 2 and more.
struct Precision {
    int digits, min_exponent;

    template <class Real>
    static constexpr Precision of() {
        return {std::numeric_limits<Real>::digits, std::numeric_limits<Real>::min_exponent};
    }
    constexpr bool operator==(const Precision&) const = default;
};

/// A function call of a computation, counted from its start. 0 is no call: what the computation does itself.
using CallNumber = std::uint32_t;

/// A call of one of the core's functions.
struct Call {
    const char* header = "";    ///< where the function stands: "vec3.hpp"
    const char* function = "";  ///< its name; of a rule, that of its struct: "Stable"
    const char* file = "";      ///< the line that calls it
    int line = 0;
    CallNumber caller = 0;  ///< the call that this line is executed in
};

/// One operation: its operands are earlier steps. A comparison's value is 1 where it holds and 0 where it does not.
struct Step {
    Operation operation = Operation::input;
    StepNumber left = 0, right = 0;
    long double value = 0;  ///< of any scalar: a long double holds them all exactly
    const char* file = "";  ///< the operation's source file; none for inputs, their rounding, and constants
    int line = 0;
    CallNumber call = 0;  ///< the innermost call in which it is done
};

/// A name given to a step.
using StepName = std::pair<StepNumber, std::string>;

/// Hears what a tape records at once: for a program of which nothing else may be left.
class TapeListener {
public:
    virtual ~TapeListener() = default;
    virtual void on_step(const Step& step) = 0;
    virtual void on_name(StepNumber step, std::string_view name) = 0;
    virtual void on_call(const Call& call) = 0;
    virtual void on_return(CallNumber to) = 0;
};

/// All operations of a computation in one scalar, in the order of execution, with the names given to some of them, and
/// the calls in which they were done.
class Tape {
public:
    /// The listener, if there is one, must outlive the recording.
    explicit Tape(Precision precision = Precision::of<double>(), TapeListener* listener = nullptr)
        : precision_(precision), listener_(listener) {}

    /// A tape that was recorded elsewhere. Operands must be earlier steps, and callers earlier calls; call 0 is no
    /// call.
    Tape(Precision precision, std::vector<Step> steps, std::vector<Call> calls, std::vector<StepName> names)
        : precision_(precision), steps_(std::move(steps)), calls_(std::move(calls)), names_(std::move(names)) {}

    /// The scalar's precision.
    Precision precision() const { return precision_; }

    /// Appends a step of the present call.
    StepNumber append(Step step) {
        step.call = call_;
        steps_.push_back(step);
        if (listener_) listener_->on_step(step);
        return static_cast<StepNumber>(steps_.size() - 1);
    }

    /// Names a step. A step may have several names, in the order given.
    void name(StepNumber step, std::string name) {
        if (listener_) listener_->on_name(step, name);
        names_.emplace_back(step, std::move(name));
    }

    const std::vector<Step>& steps() const { return steps_; }
    const Step& operator[](StepNumber step) const { return steps_[step]; }

    /// Enters a call within the present one: `call.caller` is filled in.
    void enter(Call call) {
        call.caller = call_;
        call_ = static_cast<CallNumber>(calls_.size());
        calls_.push_back(call);
        if (listener_) listener_->on_call(call);
    }
    /// Leaves the present call, if there is one.
    void leave() {
        call_ = calls_[call_].caller;
        if (listener_) listener_->on_return(call_);
    }
    const std::vector<Call>& calls() const { return calls_; }

    /// The first name of each step; empty for those without.
    std::vector<std::string> names() const {
        std::vector<std::string> all(steps_.size());
        for (const auto& [step, name] : names_)
            if (all[step].empty()) all[step] = name;
        return all;
    }

private:
    Precision precision_;
    TapeListener* listener_ = nullptr;
    std::vector<Step> steps_;
    std::vector<Call> calls_{Call{}};
    CallNumber call_ = 0;
    std::vector<StepName> names_;
};

}  // namespace glassbox
