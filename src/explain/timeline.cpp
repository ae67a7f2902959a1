#include "explain/timeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

#include "explain/loss.hpp"
#include "explain/phrases.hpp"
#include "explain/reading_order.hpp"
#include "explain/verdict_phrases.hpp"
#include "explain/words.hpp"
#include "render/option_names.hpp"

namespace glassbox {

namespace {

using story::Fate;
using story::StoryStep;
using story::Surface;

using Steps = std::span<const StoryStep>;

/// Vector operations: they serve a formula elsewhere.
bool is_general(const Step& step) { return std::string_view(step.file).ends_with("vec3.hpp"); }

/// For each step, the first `wanted` step that it leads to, itself included.
template <class Wanted>
std::vector<std::optional<StepNumber>> leads_to(Steps steps, const Wanted& wanted) {
    std::vector<std::optional<StepNumber>> found(steps.size());
    const auto earlier = [](std::optional<StepNumber> a, std::optional<StepNumber> b) {
        return !a ? b : !b ? a : std::min(*a, *b);
    };
    for (std::size_t i = steps.size(); i-- > 0;) {
        const Step& step = steps[i].step;
        if (operands(step.operation) == 0) continue;
        if (wanted(steps[i])) found[i] = static_cast<StepNumber>(i);
        for (const StepNumber operand : {step.left, step.right}) found[operand] = earlier(found[operand], found[i]);
    }
    return found;
}

/// For each step, the first one with the same operation and operands: a formula that is called twice computes
/// everything again.
std::vector<StepNumber> first_of_the_same(Steps steps) {
    std::map<std::tuple<Operation, StepNumber, StepNumber, long double>, StepNumber> seen;
    std::vector<StepNumber> first(steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const auto& [operation, left, right, value, file, line, call] = steps[i].step;
        const auto number = static_cast<StepNumber>(i);
        first[i] = operation == Operation::input ? number
                   : operation == Operation::constant
                       ? seen.try_emplace({operation, 0, 0, value}, number).first->second
                       : seen.try_emplace({operation, first[left], first[right], 0}, number).first->second;
    }
    return first;
}

std::string what_happens(Steps steps, const StoryStep& told) {
    const std::string done = operation(steps, told.step);
    return is_comparison(told.step.operation) ? done : fmt::format("{} = {}", short_number(told.checked.value), done);
}

/// Whether a comparison does not answer truly, or a number is not finite.
bool went_wrong(const StoryStep& told) {
    const Checked& checked = told.checked;
    if (!is_comparison(told.step.operation)) return !std::isfinite(checked.recorded);
    return checked.known != Known::not_at_all && checked.truth != checked.value;
}

/// Collects the events of a story.
class Teller {
public:
    explicit Teller(const Story& story) : story_(story) {}

    std::vector<Event> tell() && {
        tell_ray();
        for (std::size_t row = 0; row < story_.surfaces.size(); ++row) tell_surface(row);
        if (story_.options.stage > 1 && (!story_.ended || story_.ended->at_hit)) tell_nearest();
        if (story_.hit) tell_hit();
        if (story_.ended) tell_early_end();
        else tell_pixel();
        find_makers();
        return std::move(events_);
    }

private:
    /// A function of the core: the end of its file's path, and its name.
    struct Function {
        std::string_view file, name;
    };

    void add(std::string what, std::optional<bool> holds = {}, Function function = {}) {
        Event event;
        event.file = function.file;
        event.function = function.name;
        event.group = group_;
        event.what = std::move(what);
        event.holds = holds;
        events_.push_back(std::move(event));
    }

    /// `is_told` chooses among the steps, and may begin a new group.
    template <class IsTold>
    void tell_steps(Steps steps, std::span<const Call> calls, std::optional<std::size_t> row, const IsTold& is_told) {
        const std::vector<Symbol> written = symbols(steps);
        const auto served = leads_to(steps, [](const StoryStep& s) { return !s.name.empty() || !is_general(s.step); });
        for (const StepNumber i : in_reading_order(steps, calls)) {
            const StoryStep& told = steps[i];
            if (!is_told(i)) continue;
            const bool compares = is_comparison(told.step.operation);
            add(what_happens(steps, told), compares ? std::optional(told.checked.value != 0) : std::nullopt);
            Event& event = events_.back();
            event.formula = written[i].result.empty() ? written[i].formula : written[i].result;
            event.has_values = written[i].has_values;
            event.cancellation = is_cancellation(steps, told);
            event.failed = went_wrong(told);
            event.place = StepPlace{row, i};
            if (served[i]) event.serves = StepPlace{row, *served[i]};
            event.left = written[told.step.left].written;
            if (operands(told.step.operation) == 2) event.right = written[told.step.right].written;
        }
    }

    void tell_ray() {
        group_ = "the ray";
        add(fmt::format("the ray of column {}, row {}: P = {}, D = {}", story_.column, story_.row, triple(story_.ray.P),
                        triple(story_.ray.D)),
            {}, {"/ray.hpp", "Ray"});
        events_.back().formula = "f(t) = P + tD";
        tell_steps(story_.ray_steps, story_.ray_calls, {}, [](std::size_t) { return true; });
    }

    void tell_surface(std::size_t row) {
        const Surface& surface = story_.surfaces[row];
        group_ = fmt::format("surface {}, {}", surface.number, word(surface.kind));
        const Function rule = rule_of(surface);
        add(group_ + ", is tested", {}, rule);
        events_.back().surface = row;
        tell_steps(surface.steps, surface.calls, row, [](std::size_t) { return true; });
        if (!surface.is_finished) return;
        const bool met = is_met(surface.fate), is_wrong = (story_.own || story_.judgement) && met != surface.truly_met;
        std::string answer =
            met ? fmt::format("met at t = {}", surface.t ? short_number(surface.t->value) : "") : why(surface, story_);
        if (surface.needed_exact) answer += ", decided in exact arithmetic";
        if (is_wrong && story_.own) answer += met ? "; but truly it is missed" : "; but truly it is met";
        add(fmt::format("surface {}: {}", surface.number, answer), met, rule);
        events_.back().surface = row;
        events_.back().failed = surface.fate == Fate::overflow || is_wrong;
    }

    Function rule_of(const Surface& surface) const {
        const Options& options = story_.options;
        if (std::holds_alternative<story::TriangleTest>(surface.test))
            return {std::holds_alternative<Pluecker>(options.triangle_rule)    ? "/intersect_triangle.hpp"
                    : std::holds_alternative<Tolerance>(options.triangle_rule) ? "/tolerance.hpp"
                                                                               : "/moeller_trumbore.hpp",
                    struct_of(options.triangle_rule)};
        const bool history = std::holds_alternative<Levental2014>(options.sphere_rule);
        return {history ? "/levental_2014.hpp" : "/intersect_sphere.hpp", struct_of(options.sphere_rule)};
    }

    void tell_nearest() {
        group_ = "which is nearest";
        if (story_.not_listed > 0) add(fmt::format("{} more surfaces are missed", story_.not_listed));
        constexpr Function by{"/crossing.hpp", "nearest"};
        if (!story_.hit) add("nothing is met: the background", {}, by);
        else
            add(fmt::format(
                    "nearest of {} met: surface {}, at t = {}{}", story_.met, story_.hit->surface,
                    short_number(story_.hit->t.value),
                    story_.hit->t_by_exact ? ", not by these steps: they have too few digits, or overflow" : ""),
                {}, by);
        events_.back().failed = mark_of(story_) == story::Mark::wrong;
    }

    void tell_hit() {
        const Steps steps = story_.hit->steps;
        const auto named = leads_to(steps, [](const StoryStep& s) { return !s.name.empty(); });
        const std::vector<StepNumber> first = first_of_the_same(steps);
        const bool cut = story_.hit->shade && story_.hit->shade->model == ShadingModel::levental_2014;
        tell_steps(steps, story_.hit->calls, {}, [&](std::size_t i) {
            const std::string goal = named[i] ? steps[*named[i]].name : "";
            if (i < story_.hit->tested_before || first[i] != i) return false;
            if (cut && goal.starts_with("sum.")) return false;  // that model adds bytes: the sum is the story's own
            if (goal.starts_with("point.")) group_ = "the point";
            else if (goal.starts_with("n.")) group_ = "the normal";
            else if (!goal.empty()) group_ = "the light";
            else if (std::string_view(steps[i].step.file).ends_with("rgb.hpp")) group_ = "the bytes";
            return true;
        });
    }

    void tell_pixel() {
        group_ = "the pixel";
        const Function by = story_.options.stage == 1         ? Function{"/ray_color.hpp", "ray_color"}
                            : story_.hit && story_.hit->shade ? Function{"/shade.hpp", "to_rgb"}
                                                              : Function{};
        if (story_.hit && story_.hit->shade && story_.hit->shade->model == ShadingModel::levental_2014) {
            const story::Shade& shade = *story_.hit->shade;
            add(fmt::format("cut to bytes: ambient {} + diffuse {} + specular {}", triple(shade.ambient.bytes),
                            triple(shade.diffuse.bytes), triple(shade.specular.bytes)),
                {}, by);
        }
        add(fmt::format("the ray brings {}", triple(story_.traced)), {}, by);
        if (story_.border) add(fmt::format("the border is painted over it: {}", triple(story_.color)));
    }

    /// "at my/2-spheres/chord.hpp:30"; of what ours did, the learner's line that called it is told, too.
    std::string for_which_line(const StepPlace& place) const {
        const Step& step = tape_of(story_, place)[place.step].step;
        const auto is_own = [&](std::string_view file) {
            const std::span<const SourceFile> own = story_.own ? story_.own->files() : std::span<const SourceFile>();
            return std::ranges::any_of(own, [&](const SourceFile& header) { return header.path == file; });
        };
        const auto line_of = [&](std::string_view file, int line) {
            return fmt::format("{}:{}", is_own(file) ? file : source(file), line);
        };
        const std::string its_line = line_of(step.file, step.line);
        if (is_own(step.file)) return "at " + its_line;
        std::string from;
        for (const CallNumber number : calls_around(story_, place)) {
            const Call& call = calls_of(story_, place)[number];
            if (is_own(call.file)) from = line_of(call.file, call.line);
        }
        return from.empty() ? "at " + its_line : fmt::format("for {}, at {}", from, its_line);
    }

    /// The last event of a program that did not get to the end.
    void tell_early_end() {
        std::optional<StepPlace> last;
        const auto last_of = [&](std::optional<std::size_t> row, Steps steps) {
            if (!steps.empty()) last = StepPlace{row, static_cast<StepNumber>(steps.size() - 1)};
        };
        last_of({}, story_.ray_steps);
        if (story_.hit) last_of({}, story_.hit->steps);
        else if (!story_.surfaces.empty()) last_of(story_.surfaces.size() - 1, story_.surfaces.back().steps);
        group_ = "the end";
        std::string what = story_.ended->words;
        if (const Call& in = story_.ended->in; *in.function != '\0')
            what = fmt::format("in `{}` of {} {}", in.function, in.header, what);
        // Inputs have no line: nothing had been computed with them yet.
        if (last && *tape_of(story_, *last)[last->step].step.file == '\0') last.reset();
        if (last)
            what += (what.ends_with('?') ? " The last" : "; the last") +
                    (" step before that was done " + for_which_line(*last));
        add(std::move(what));
        events_.back().failed = true;
        events_.back().stopped_after = last;
    }

    /// Finds the event that made each operand. The hit's tape repeats the test of its surface, and some steps of its
    /// own: these were told where they were done first.
    void find_makers() {
        std::map<std::pair<std::optional<std::size_t>, StepNumber>, std::size_t> made;
        for (std::size_t i = 0; i < events_.size(); ++i)
            if (const auto& place = events_[i].place) made[{place->row, place->step}] = i;
        const std::vector<StepNumber> first =
            story_.hit ? first_of_the_same(story_.hit->steps) : std::vector<StepNumber>{};
        std::optional<std::size_t> tested;
        for (std::size_t row = 0; row < story_.surfaces.size(); ++row)
            if (story_.hit && story_.surfaces[row].number == story_.hit->surface) tested = row;
        const auto maker = [&](StepPlace place) -> std::optional<std::size_t> {
            if (!place.row && story_.hit) {
                place.step = first[place.step];
                if (place.step < story_.hit->tested_before) place.row = tested;
            }
            const auto found = made.find({place.row, place.step});
            return found == made.end() ? std::nullopt : std::optional(found->second);
        };
        for (Event& event : events_) {
            if (!event.place) continue;
            const Step& step = tape_of(story_, *event.place)[event.place->step].step;
            event.left_made_by = maker({event.place->row, step.left});
            if (operands(step.operation) == 2) event.right_made_by = maker({event.place->row, step.right});
        }
    }

    const Story& story_;
    std::string group_;
    std::vector<Event> events_;
};

}  // namespace

std::vector<Event> timeline(const Story& story) { return Teller(story).tell(); }

std::span<const StoryStep> tape_of(const Story& story, const StepPlace& place) {
    if (place.row) return story.surfaces[*place.row].steps;
    return story.hit ? Steps(story.hit->steps) : Steps(story.ray_steps);
}

std::span<const Call> calls_of(const Story& story, const StepPlace& place) {
    if (place.row) return story.surfaces[*place.row].calls;
    return story.hit ? std::span<const Call>(story.hit->calls) : std::span<const Call>(story.ray_calls);
}

std::vector<CallNumber> calls_around(const Story& story, const StepPlace& place) {
    const std::span<const Call> calls = calls_of(story, place);
    std::vector<CallNumber> around;
    for (CallNumber call = tape_of(story, place)[place.step].step.call; call != 0; call = calls[call].caller)
        around.push_back(call);
    std::reverse(around.begin(), around.end());
    return around;
}

std::size_t stepped(std::span<const Event> events, std::size_t now, StepTo to, const std::vector<bool>& shown) {
    if (events.empty()) return 0;
    const std::size_t last = events.size() - 1;
    now = std::min(now, last);
    const auto is_shown = [&](std::size_t i) { return shown.empty() || (i < shown.size() && shown[i]); };
    const auto next = [&](std::size_t from, const auto& wanted) {
        for (std::size_t i = from; i <= last; ++i)
            if (is_shown(i) && wanted(events[i])) return i;
        return now;
    };
    const auto before = [&](std::size_t end) {
        for (std::size_t i = end; i-- > 0;)
            if (is_shown(i)) return i;
        return now;
    };
    const auto any = [](const Event&) { return true; };
    switch (to) {
        case StepTo::first:
            return next(0, any);
        case StepTo::back:
            return before(now);
        case StepTo::forward:
            return next(now + 1, any);
        case StepTo::last:
            return before(last + 1);
        case StepTo::next_no:
            return next(now + 1, says_no);
        case StepTo::next_failed:
            return next(now + 1, [](const Event& event) { return event.failed; });
        case StepTo::next_cancellation:
            return next(now + 1, [](const Event& event) { return event.cancellation; });
    }
    return now;
}

std::vector<bool> feeding(std::span<const Event> events, std::size_t event) {
    std::vector<bool> feeds(events.size(), false);
    if (event >= events.size()) return feeds;
    // A number is made after its operands, in whatever order they are listed.
    std::vector<std::size_t> open{event};
    while (!open.empty()) {
        const std::size_t next = open.back();
        open.pop_back();
        if (feeds[next]) continue;
        feeds[next] = true;
        for (const auto& made_by : {events[next].left_made_by, events[next].right_made_by})
            if (made_by && *made_by < events.size()) open.push_back(*made_by);
    }
    return feeds;
}

}  // namespace glassbox
