#include "explain/judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "explain/loss.hpp"
#include "explain/scalar_of_steps.hpp"
#include "numerics/graded.hpp"
#include "render/parallel.hpp"
#include "render/search/exact_crossing.hpp"

namespace glassbox {

namespace {

using namespace story;
using Steps = std::span<const StoryStep>;

/// Calls `use(shape, rule)` with a surface and the chosen rule for it.
template <class Use>
auto with_chosen_rule(const engine::Engine& surfaces, std::size_t number, const Options& options, const Use& use) {
    return surfaces.with_surface(number, [&]<class Shape>(const Shape& shape) {
        if constexpr (std::is_same_v<Shape, Sphere<double>>) return use(shape, options.sphere_rule);
        else return use(shape, options.triangle_rule);
    });
}

/// Weighs the answers of one ray's tests in the scalar Real.
template <class Real>
class Weighing {
public:
    using Number = Graded<Real>;

    Weighing(const engine::Engine& surfaces, const Options& options, const TracedPixel& pixel)
        : surfaces_(surfaces), options_(options), ray_(convert<Number>(pixel.ray)) {
        if (!pixel.nearest) return;
        shown_ = pixel.nearest->surface;
        const Crossing<Number> crossing = crossing_with(*shown_);
        t_ = crossing.t;
        keep(crossing.met, *shown_, {});
    }

    /// Weighs the answer that this surface is not seen.
    void ask(std::size_t surface) {
        if (surface == shown_) return;
        const Crossing<Number> crossing = crossing_with(surface);
        const GradedTruth missed = !crossing.met;
        if (!shown_ || (missed.holds && missed.sureness >= least_)) return keep(missed, surface, {});
        const GradedTruth farther = surface < *shown_ ? t_ <= crossing.t : t_ < crossing.t;
        const GradedTruth unseen = missed | farther;
        const bool by_order = !missed.holds || (farther.holds && farther.sureness > missed.sureness);
        keep(unseen, surface, by_order ? shown_ : std::nullopt);
    }

    const std::optional<LeastSure>& least() const { return found_; }

private:
    Crossing<Number> crossing_with(std::size_t number) const {
        return with_chosen_rule(surfaces_, number, options_, [&](const auto& shape, const auto& rule) {
            const Silent silent;
            return intersect(ray_, convert<Number>(shape), Chosen{rule}, silent);
        });
    }

    /// An answer that should hold, and does not, cannot be sure: the bounds leave it open.
    void keep(const GradedTruth& answer, std::size_t surface, const std::optional<std::size_t>& nearer) {
        const double sureness = answer.holds ? answer.sureness : std::min(answer.sureness, 1.0);
        if (found_ && !(sureness < least_)) return;
        least_ = sureness;
        found_ = LeastSure{};
        found_->sureness = sureness;
        found_->surface = surface;
        found_->nearer_than = nearer;
    }

    const engine::Engine& surfaces_;
    const Options& options_;
    Ray<Number> ray_;
    std::optional<std::size_t> shown_;
    Number t_;
    double least_ = std::numeric_limits<double>::infinity();
    std::optional<LeastSure> found_;
};

double sureness_of(Steps steps, const Step& comparison) {
    const auto bounded = [&](StepNumber number) {
        const Checked& checked = steps[number].checked;
        return Bounded(checked.value, checked.error);
    };
    return sureness_of_order(bounded(comparison.left), bounded(comparison.right));
}

/// Of a comparison's operands the one that is no constant.
StepNumber compared_number(Steps steps, const Step& comparison) {
    return steps[comparison.left].step.operation == Operation::constant ? comparison.right : comparison.left;
}

/// The number whose comparison is so sure, up to what rounding may have changed in the quotient.
std::optional<StepNumber> number_with(Steps steps, double sureness) {
    for (const StoryStep& told : steps) {
        if (!is_comparison(told.step.operation)) continue;
        const double its = sureness_of(steps, told.step);
        if (its == sureness || std::abs(its - sureness) <= 1e-9 * sureness) return compared_number(steps, told.step);
    }
    return {};
}

std::optional<StepNumber> named(Steps steps, std::string_view name) {
    const auto found = std::find_if(steps.begin(), steps.end(), [&](const StoryStep& s) { return s.name == name; });
    if (found == steps.end()) return {};
    return static_cast<StepNumber>(found - steps.begin());
}

/// Where a surface's t was computed: a triangle's has a step of its own, a sphere's is one of its roots.
std::optional<StepNumber> step_of_t(Steps steps) {
    if (const auto t = named(steps, "t")) return t;
    const auto t0 = named(steps, "t₀");
    return t0 && steps[*t0].checked.recorded > 0 ? t0 : named(steps, "t₁");
}

/// Finds, among a number and the steps that lead to it, the one that lost the most bits itself.
void find_worst_before(LeastSure& least, Steps steps) {
    std::vector<bool> leads(steps.size(), false);
    leads[*least.step] = true;
    for (std::size_t i = *least.step + 1; i-- > 0;) {
        if (!leads[i]) continue;
        const Step& step = steps[i].step;
        if (operands(step.operation) > 0) leads[step.left] = leads[step.right] = true;
        const double loss = bits_lost_by(steps, steps[i]);
        if (!(loss > least.worst_loss)) continue;
        least.worst = static_cast<StepNumber>(i);
        least.worst_loss = loss;
    }
}

/// Whether the rule, computed without any rounding, judges the surface as the search did.
bool says_the_same(const engine::Engine& surfaces, const Options& options, const Ray<double>& ray, std::size_t number,
                   bool met) {
    return with_chosen_rule(surfaces, number, options, [&](const auto& shape, const auto& rule) {
        return !is_geometry(rule) && exact_crossing(ray, shape, rule).has_value() == met;
    });
}

}  // namespace

Judgement judged(const std::shared_ptr<const engine::Engine>& surfaces, const Options& options,
                 const TracedPixel& pixel, const TrueHits& truth) {
    Judgement result;
    if (pixel.nearest) result.shown = pixel.nearest->surface;
    result.truth = truth.nearest;
    result.truth_needed_exact = truth.needed_exact;
    result.verdict = verdict(result.shown, result.truth);
    result.shown_is_there = result.shown && truth.has(*result.shown);
    if (result.verdict == Verdict::wrong_surface && result.shown_is_there)
        result.at_once = ReferenceSearch(surfaces).order(pixel.ray, *result.shown, *result.truth) == 0;
    std::size_t rightly_met = 0;
    for (const auto& hit : pixel.met) rightly_met += truth.has(hit.surface) ? 1 : 0;
    result.wrongly_met = pixel.met.size() - rightly_met;
    result.wrongly_missed = truth.met.size() - rightly_met;
    if (const auto surface = judged_wrongly(result)) {
        const bool met =
            std::any_of(pixel.met.begin(), pixel.met.end(), [&](const auto& hit) { return hit.surface == *surface; });
        result.by_rule = met != truth.has(*surface) && says_the_same(*surfaces, options, pixel.ray, *surface, met);
    }
    return result;
}

std::optional<std::size_t> judged_wrongly(const Judgement& judgement) {
    if (judgement.verdict == Verdict::right) return {};
    return judgement.shown && !judgement.shown_is_there ? judgement.shown : judgement.truth;
}

std::optional<LeastSure> least_sure(const std::shared_ptr<const engine::Engine>& surfaces, const Options& options,
                                    const TracedPixel& pixel, const Job& job) {
    return with_scalar_of_steps(options.scalar, [&]<class Real>(std::type_identity<Real>) {
        Weighing<Real> weighing(*surfaces, options, pixel);
        const auto ask = [&](std::size_t surface) {
            throw_if_stopped(job);
            weighing.ask(surface);
        };
        // A search that proves its answers passes over surfaces only where their boxes are surely missed.
        if (is_proven(options.scalar)) ReferenceSearch(surfaces).for_each_tested(pixel.ray, ask);
        else
            for (std::size_t surface = 0; surface < surfaces->size(); ++surface) ask(surface);
        return weighing.least();
    });
}

void find_step(LeastSure& least, const std::vector<Surface>& rows) {
    const auto row =
        std::find_if(rows.begin(), rows.end(), [&](const Surface& s) { return s.number == least.surface; });
    if (row == rows.end()) return;
    least.row = static_cast<std::size_t>(row - rows.begin());
    const Steps steps = row->steps;
    least.step = least.nearer_than ? step_of_t(steps) : number_with(steps, least.sureness);
    least.name = least.nearer_than ? "t" : "a number";
    if (!least.step) return;
    const StoryStep& told = steps[*least.step];
    least.name = told.name.empty() ? fmt::format("the result of line {}", told.step.line) : told.name;
    find_worst_before(least, steps);
}

std::vector<std::string> turned(const Surface& surface) {
    const Steps steps = surface.steps;
    std::vector<std::string> names;
    for (const auto& [step, name, checked] : steps) {
        if (!is_comparison(step.operation) || checked.known == Known::not_at_all || checked.value == checked.truth)
            continue;
        const std::string& its_name = steps[compared_number(steps, step)].name;
        if (!its_name.empty() && std::find(names.begin(), names.end(), its_name) == names.end())
            names.push_back(its_name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace glassbox
