#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "explain/explain.hpp"
#include "explain/recorded_test.hpp"
#include "explain/replay.hpp"
#include "explain/story.hpp"

namespace glassbox {

/// Looks up a tape's numbers with their bounds and true values; without a replay, only their values.
class Lookup {
public:
    explicit Lookup(const Tape& tape, Detail detail = Detail::whole) : tape_(tape) {
        if (detail != Detail::recorded) checked_ = replay(tape);
    }

    template <class Real>
    story::Number operator()(const Recorded<Real>& number) const {
        return number.tape() && !checked_.empty() ? checked_[number.step()] : unchecked(number.value());
    }
    template <class Real>
    std::optional<story::Number> operator()(const std::optional<Recorded<Real>>& number) const {
        return number ? std::optional((*this)(*number)) : std::nullopt;
    }
    template <class Real>
    story::Vector operator()(const Vec3<Recorded<Real>>& v) const {
        return {(*this)(v.x), (*this)(v.y), (*this)(v.z)};
    }

    /// The number of a step; there must be a replay.
    story::Number at(StepNumber step) const { return checked_[step]; }

    /// The tape's first steps with their names and checks; none without a replay.
    std::vector<story::StoryStep> steps(std::size_t count) const {
        std::vector<story::StoryStep> told;
        if (checked_.empty()) return told;
        told.reserve(count);
        std::vector<std::string> names = tape_.names();
        for (std::size_t i = 0; i < count; ++i) told.push_back({tape_.steps()[i], std::move(names[i]), checked_[i]});
        return told;
    }

private:
    const Tape& tape_;
    std::vector<Checked> checked_;
};

/// What a test told: its numbers with their checks, and its steps.
struct ToldTest {
    using Number = story::Number;

    bool met = false;
    std::optional<Number> t;                       ///< if the rule computed it
    std::optional<Number> discriminant, t0, t1;    ///< a sphere's
    std::optional<Number> a, b, c, sum, deficit;   ///< a triangle's
    std::optional<std::array<Number, 3>> weights;  ///< a triangle's
    std::vector<story::StoryStep> steps;
    std::vector<Call> calls;  ///< in which they were done
};

/// What a recorded test told. `weights` are the test's, recorded before the tape was replayed.
template <class Real, class Shape>
ToldTest looked_up(const RecordedTest<Real, Shape>& test, const std::optional<std::array<Recorded<Real>, 3>>& weights,
                   const Lookup& look) {
    const NamingProbe<Real>& h = test.heard;
    ToldTest result{.met = test.crossing.met,
                    .t = {},
                    .discriminant = look(h.discriminant),
                    .t0 = look(h.t0),
                    .t1 = look(h.t1),
                    .a = look(h.a),
                    .b = look(h.b),
                    .c = look(h.c),
                    .sum = look(h.sum),
                    .deficit = look(h.deficit),
                    .weights = {},
                    .steps = look.steps(test.step_count),
                    .calls = test.tape.calls()};
    if (weights) result.weights = {look((*weights)[0]), look((*weights)[1]), look((*weights)[2])};
    if (!test.crossing.t.tape()) return result;
    result.t = look(test.crossing.t);
    std::string& its_name = result.steps[test.crossing.t.step()].name;
    if (its_name.empty()) its_name = "t";
    return result;
}

}  // namespace glassbox
