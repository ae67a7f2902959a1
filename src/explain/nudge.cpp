#include "explain/nudge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "explain/reading_order.hpp"
#include "explain/scalar_of_steps.hpp"
#include "explain/symbols.hpp"
#include "explain/told_test.hpp"
#include "render/search/exact_crossing.hpp"

namespace glassbox {

namespace {

/// The number that is so many of the scalar's numbers further up, but not beyond the largest finite one.
template <class Real>
double moved(double value, int by) {
    if (by == 0) return value;
    using Stepped = std::conditional_t<std::is_same_v<Real, float>, float, double>;
    constexpr Stepped most = std::numeric_limits<Stepped>::max();
    auto now = static_cast<Stepped>(value);
    for (int i = 0; i < std::min(std::abs(by), farthest_nudge); ++i) now = std::nextafter(now, by > 0 ? most : -most);
    return now;
}

void add_vector(std::vector<std::pair<std::string, double*>>& all, const std::string& name, Vec3<double>& v) {
    all.emplace_back(name + ".x", &v.x);
    all.emplace_back(name + ".y", &v.y);
    all.emplace_back(name + ".z", &v.z);
}

using Inputs = std::vector<std::pair<std::string, double*>>;

Inputs inputs_of(Ray<double>& ray, Sphere<double>& sphere) {
    Inputs all;
    add_vector(all, "P", ray.P);
    add_vector(all, "D", ray.D);
    add_vector(all, "centre", sphere.C);
    all.emplace_back("radius", &sphere.r);
    return all;
}

Inputs inputs_of(Ray<double>& ray, Triangle<double>& triangle) {
    Inputs all;
    add_vector(all, "P", ray.P);
    add_vector(all, "D", ray.D);
    add_vector(all, "A", triangle.A);
    add_vector(all, "B", triangle.B);
    add_vector(all, "C", triangle.C);
    return all;
}

Sphere<double> shape_of(const story::SphereTest& test) { return {test.center, test.radius}; }
Triangle<double> shape_of(const story::TriangleTest& test) {
    return {test.vertices[0], test.vertices[1], test.vertices[2]};
}

const SphereRule& rule_for(const story::SphereTest&, const Options& options) { return options.sphere_rule; }
const TriangleRule& rule_for(const story::TriangleTest&, const Options& options) { return options.triangle_rule; }

struct Outcome {
    std::vector<std::pair<std::string, Answer>> answers;
    NudgedVerdict verdict;
};

template <class Real, class Shape, class Rule>
Outcome outcome(const Ray<double>& ray, const Shape& shape, const Rule& rule, Scalar scalar) {
    RecordedTest<Real, Shape> test(ray, shape, rule);
    name(test.crossing.t, "t");
    const std::vector<story::StoryStep> steps = Lookup(test.tape).steps(test.step_count);
    const std::vector<Symbol> written = symbols(steps);
    Outcome result;
    for (const StepNumber i : in_reading_order(steps, test.tape.calls())) {
        const auto& [step, its_name, checked] = steps[i];
        if (!is_comparison(step.operation)) continue;
        const auto same = [&](const auto& answer) { return answer.first == written[i].formula; };
        if (std::ranges::any_of(result.answers, same)) continue;
        Answer answer{steps[step.left].checked, checked.value != 0, {}};
        if (checked.known != Known::not_at_all) answer.truly = checked.truth != 0;
        result.answers.emplace_back(written[i].formula, answer);
    }
    const bool valid = is_valid(ray);
    result.verdict.truly = valid && exact_crossing(ray, shape, rule).has_value();
    result.verdict.met = is_proven(scalar) ? result.verdict.truly : valid && test.crossing.met;
    return result;
}

template <class Real, class Test>
Nudged nudged_test(const Story& story, const Test& test, std::span<const Nudge> nudges) {
    Ray<double> ray = story.ray;
    auto shape = shape_of(test);
    const auto& rule = rule_for(test, story.options);
    const Outcome before = outcome<Real>(ray, shape, rule, story.options.scalar);
    Nudged result;
    for (const auto& [name, number] : inputs_of(ray, shape)) {
        int by = 0;
        for (const Nudge& nudge : nudges)
            if (nudge.input == name) by = std::clamp(by + nudge.by, -farthest_nudge, farthest_nudge);
        const double was = *number, is = moved<Real>(was, by);
        if (name != "radius" || is > 0) *number = is;
        result.inputs.push_back({name, was, *number, by});
    }
    const Outcome after = outcome<Real>(ray, shape, rule, story.options.scalar);
    result.before = before.verdict;
    result.after = after.verdict;
    for (const auto& [condition, answer] : before.answers) result.answers.push_back({condition, answer, {}});
    for (const auto& [condition, answer] : after.answers) {
        const auto known = std::ranges::find(result.answers, condition, &NudgedAnswer::condition);
        if (known == result.answers.end()) result.answers.push_back({condition, {}, answer});
        else known->after = answer;
    }
    return result;
}

}  // namespace

Nudged nudged(const Story& story, std::size_t row, std::span<const Nudge> nudges) {
    return std::visit(
        [&](const auto& test) {
            return with_scalar_of_steps(story.options.scalar, [&]<class Real>(std::type_identity<Real>) {
                return nudged_test<Real>(story, test, nudges);
            });
        },
        story.surfaces[row].test);
}

std::string in_words(const NudgedVerdict& verdict) {
    std::string text = verdict.met ? "met" : "missed";
    if (verdict.met != verdict.truly) text += verdict.truly ? ", and truly met" : ", and truly missed";
    return text;
}

}  // namespace glassbox
