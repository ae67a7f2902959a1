#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <variant>

#include "explain/inputs.hpp"
#include "explain/naming_probe.hpp"
#include "numerics/recorded.hpp"

namespace glassbox {

/// A surface's test by a rule, with each operation recorded on a tape. More may be recorded after it.
template <class Real, class Shape>
struct RecordedTest {
    using Number = Recorded<Real>;

    Tape tape;
    NamingProbe<Real> heard;
    Ray<Number> ray;
    decltype(input<Real>(std::declval<Tape&>(), std::declval<const Shape&>())) shape;
    Crossing<Number> crossing;
    std::size_t step_count;  ///< of the test

    /// `rule` is a variant of rules: a SphereRule, a TriangleRule, or one of fewer.
    template <class Rule>
    RecordedTest(const Ray<double>& by, const Shape& tested, const Rule& rule, TapeListener* listener = nullptr)
        : tape(Precision::of<Real>(), listener),
          ray(input<Real>(tape, by)),
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

}  // namespace glassbox
