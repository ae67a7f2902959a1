#pragma once
#include <cmath>
#include <stdexcept>

/// Numbers that do not always know which of two is larger, like those of lesson 6: a formula must cope with that.
namespace glassbox::test {

/// Yes, no or undecided. Code that takes it for a bool, as a bare `if (t > 0)` does, is detected.
class UnsureTruth {
public:
    constexpr UnsureTruth(bool truth) : state_(truth ? State::yes : State::no) {}
    static constexpr UnsureTruth undecided() { return UnsureTruth(State::undecided); }

    friend constexpr bool surely(UnsureTruth truth) { return truth.state_ == State::yes; }
    friend constexpr bool possibly(UnsureTruth truth) { return truth.state_ != State::no; }

    explicit operator bool() const {
        throw std::logic_error("a Truth stands in an if, a ?: or an || by itself: ask possibly(…) or surely(…) of it");
    }

    friend constexpr UnsureTruth operator!(UnsureTruth truth) {
        return surely(truth) ? UnsureTruth(false) : possibly(truth) ? truth : UnsureTruth(true);
    }
    friend constexpr UnsureTruth operator&(UnsureTruth a, UnsureTruth b) {
        if (!possibly(a) || !possibly(b)) return false;
        return surely(a) && surely(b) ? UnsureTruth(true) : undecided();
    }
    friend constexpr UnsureTruth operator&&(UnsureTruth a, UnsureTruth b) { return a & b; }
    friend constexpr UnsureTruth operator&&(UnsureTruth a, bool b) { return a & b; }  // rather than two bools
    friend constexpr UnsureTruth operator&&(bool a, UnsureTruth b) { return a & b; }

    friend constexpr UnsureTruth operator!=(UnsureTruth a, UnsureTruth b) {
        if ((possibly(a) && !surely(a)) || (possibly(b) && !surely(b))) return undecided();
        return surely(a) != surely(b);
    }

private:
    enum class State : unsigned char { no, yes, undecided };
    constexpr explicit UnsureTruth(State state) : state_(state) {}
    State state_;
};

/// A number that is known to within 1: comparing it with one that is no further away is undecided.
struct Unsure {
    double value = 0;

    constexpr Unsure() = default;
    constexpr Unsure(double number) : value(number) {}

    friend constexpr Unsure operator-(Unsure a) { return -a.value; }
    friend constexpr Unsure operator+(Unsure a, Unsure b) { return a.value + b.value; }
    friend constexpr Unsure operator-(Unsure a, Unsure b) { return a.value - b.value; }
    friend constexpr Unsure operator*(Unsure a, Unsure b) { return a.value * b.value; }
    friend constexpr Unsure operator/(Unsure a, Unsure b) { return a.value / b.value; }
    friend Unsure sqrt(Unsure a) { return std::sqrt(a.value); }
    friend Unsure abs(Unsure a) { return std::abs(a.value); }

    friend constexpr UnsureTruth operator<(Unsure a, Unsure b) {
        if (a.value < b.value - 1) return true;
        return a.value > b.value + 1 ? UnsureTruth(false) : UnsureTruth::undecided();
    }
    friend constexpr UnsureTruth operator>(Unsure a, Unsure b) { return b < a; }
    friend constexpr UnsureTruth operator<=(Unsure a, Unsure b) { return !(b < a); }
    friend constexpr UnsureTruth operator>=(Unsure a, Unsure b) { return !(a < b); }
    friend constexpr UnsureTruth operator!=(Unsure a, Unsure b) {
        return possibly(a < b) && possibly(b < a) ? UnsureTruth::undecided() : UnsureTruth(true);
    }
    friend constexpr UnsureTruth operator==(Unsure a, Unsure b) { return !(a != b); }
};

}  // namespace glassbox::test
