#pragma once

namespace glassbox {

/// A truth value that may be unknown, by Kleene's strong three-valued logic: the result of comparing two uncertain
/// numbers.
class Kleene {
public:
    constexpr Kleene(bool truth) : state_(truth ? State::yes : State::no) {}
    static constexpr Kleene undecided() { return Kleene(State::undecided); }

    friend constexpr bool surely(Kleene k) { return k.state_ == State::yes; }
    friend constexpr bool possibly(Kleene k) { return k.state_ != State::no; }

    friend constexpr Kleene operator!(Kleene k) {
        return k.state_ == State::undecided ? k : Kleene(k.state_ == State::no);
    }
    friend constexpr Kleene operator&(Kleene a, Kleene b) {
        if (!possibly(a) || !possibly(b)) return false;
        return surely(a) && surely(b) ? Kleene(true) : undecided();
    }
    friend constexpr Kleene operator&&(Kleene a, Kleene b) { return a & b; }
    friend constexpr Kleene operator!=(Kleene a, Kleene b) {
        if (a.state_ == State::undecided || b.state_ == State::undecided) return undecided();
        return a.state_ != b.state_;
    }

private:
    enum class State : unsigned char { no, yes, undecided };
    constexpr explicit Kleene(State state) : state_(state) {}
    State state_;
};

}  // namespace glassbox
