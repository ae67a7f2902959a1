#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "explain/explain.hpp"
#include "explain/inputs.hpp"
#include "explain/naming_probe.hpp"
#include "explain/replay.hpp"
#include "explain/story.hpp"
#include "render/rules.hpp"

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

/// A surface's test by a rule, with each operation recorded on a tape. More may be recorded after it.
template <class Real, class Shape>
struct RecordedTest {
    using Number = Recorded<Real>;

    Tape tape{Precision::of<Real>()};
    NamingProbe<Real> heard;
    Ray<Number> ray;
    decltype(input<Real>(std::declval<Tape&>(), std::declval<const Shape&>())) shape;
    Crossing<Number> crossing;
    std::size_t step_count;  ///< of the test

    /// `rule` is a SphereRule or a TriangleRule.
    template <class Rule>
    RecordedTest(const Ray<double>& by, const Shape& tested, const Rule& rule)
        : ray(input<Real>(tape, by)),
          shape(input<Real>(tape, tested)),
          crossing(std::visit([&](const auto& chosen) { return intersect(ray, shape, chosen, heard); }, rule)),
          step_count(tape.steps().size()) {}
    RecordedTest(const RecordedTest&) = delete;  // the numbers know their tape by its address
    RecordedTest& operator=(const RecordedTest&) = delete;

    /// The weights of a triangle that the line meets, recorded after all that is there. Only the tolerance rule tells
    /// the sum that they are parts of.
    std::optional<std::array<Number, 3>> weights() const {
        if (!heard.sum || heard.sum->value() == 0) return {};
        return std::array{*heard.a / *heard.sum, *heard.b / *heard.sum, *heard.c / *heard.sum};
    }
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
