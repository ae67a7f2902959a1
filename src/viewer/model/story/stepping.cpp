#include "viewer/model/story/stepping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "viewer/model/story/predicting.hpp"
#include "viewer/model/story/steps_now.hpp"

namespace glassbox {

namespace {

bool has_steps(const ViewerState& state, const Results& results) {
    return steps_now(state, results).story && state.step < steps_shown(state, results).size();
}

void stand_on(ViewerState& state, std::size_t event) {
    state.playing = false;
    state.step = event;
}

std::vector<StackLine> stack_at(const Steps& steps, std::size_t event) {
    return call_stack(*steps.story, steps.timeline[event]);
}

bool on_same_tape(const Event& a, const Event& b) { return a.place && b.place && a.place->row == b.place->row; }

/// How many lines of two stacks, from the outermost on, are in the same calls.
std::size_t common_calls(const std::vector<StackLine>& a, const std::vector<StackLine>& b) {
    std::size_t count = 0;
    while (count < a.size() && count < b.size() && a[count].call == b[count].call &&
           (count == 0 || a[count - 1] == b[count - 1]))
        ++count;
    return count;
}

/// Goes to the first event for which `is_beyond(its common calls with this one, its stack)`; the level is kept, or that
/// of the caller if the function was left.
template <class IsBeyond>
void go_beyond(ViewerState& state, const Results& results, const IsBeyond& is_beyond) {
    const std::vector<bool> kept = events_kept(state, results);
    const std::span<const Event> events = steps_shown(state, results);
    const std::size_t level = level_now(state, results);
    const std::vector<StackLine> from = stack_at(steps_now(state, results), state.step);
    for (std::size_t i = state.step + 1; i < events.size(); ++i) {
        if (!kept.empty() && !kept[i]) continue;
        const std::vector<StackLine> to = stack_at(steps_now(state, results), i);
        const std::size_t common = on_same_tape(events[state.step], events[i]) ? common_calls(from, to) : 0;
        if (!is_beyond(common, to)) continue;
        stand_on(state, i);
        if (!to.empty()) look_at_level(state, std::min({level, to.size() - 1, std::max<std::size_t>(common, 1) - 1}));
        return;
    }
}

void test_nudged(ViewerState& state, const Results& results) {
    Stepping& stepping = state.stepping;
    stepping.nudged = std::make_shared<const Nudged>(nudged(*results.story, stepping.nudged_row, stepping.nudges));
}

/// Whether the verdict of that surface may be seen.
bool verdict_is_seen(const ViewerState& state, const Results& results, std::size_t row) {
    return std::ranges::any_of(steps_shown(state, results),
                               [&](const Event& event) { return event.surface == row && event.holds; });
}

}  // namespace

void follow_steps(ViewerState& state, const Results& results) {
    Stepping& stepping = state.stepping;
    const std::shared_ptr<const Story>& story = steps_now(state, results).story;
    if (stepping.of != story) {
        Stepping fresh;
        fresh.of = story;
        fresh.pane = stepping.pane;
        fresh.nudge_by = stepping.nudge_by;
        stepping = std::move(fresh);
    }
    const auto row = stepping.pane == StepsPane::nudge ? row_to_nudge(state, results) : std::nullopt;
    if (row && (!stepping.nudged || stepping.nudged_row != *row)) {
        stepping.nudged_row = *row;
        test_nudged(state, results);
    }
    if (!stepping.fed) return;
    const std::vector<bool> kept = events_kept(state, results);
    if (state.step >= kept.size() || !kept[state.step]) stepping.fed.reset();
}

void go(ViewerState& state, const Results& results, StepTo to) {
    if (!steps_now(state, results).story) return;
    state.playing = false;
    state.step = stepped(steps_shown(state, results), state.step, to, events_kept(state, results));
}

void jump(ViewerState& state, const Results& results, std::size_t event) {
    if (!has_steps(state, results) || event >= steps_shown(state, results).size() || event == state.step) return;
    state.stepping.back.push_back(state.step);
    state.stepping.forth.clear();
    stand_on(state, event);
}

void jump_back(ViewerState& state, const Results& results) {
    Stepping& stepping = state.stepping;
    if (!has_steps(state, results) || stepping.back.empty()) return;
    stepping.forth.push_back(state.step);
    stand_on(state, stepping.back.back());
    stepping.back.pop_back();
}

void jump_forth(ViewerState& state, const Results& results) {
    Stepping& stepping = state.stepping;
    if (!has_steps(state, results) || stepping.forth.empty()) return;
    stepping.back.push_back(state.step);
    stand_on(state, stepping.forth.back());
    stepping.forth.pop_back();
}

void jump_to_operand(ViewerState& state, const Results& results, bool second) {
    if (!has_steps(state, results)) return;
    const Event& event = steps_now(state, results).timeline[state.step];
    if (const auto made_by = second ? event.right_made_by : event.left_made_by) jump(state, results, *made_by);
}

std::vector<bool> events_kept(const ViewerState& state, const Results& results) {
    if (!state.stepping.fed) return {};
    return feeding(steps_now(state, results).timeline, *state.stepping.fed);
}

void show_only_feeding(ViewerState& state, const Results& results, bool on) {
    state.stepping.fed.reset();
    if (on && has_steps(state, results) && steps_now(state, results).timeline[state.step].place)
        state.stepping.fed = state.step;
}

std::string hidden_in_words(const ViewerState& state, const Results& results) {
    const Steps& steps = steps_now(state, results);
    if (!state.stepping.fed || *state.stepping.fed >= steps.timeline.size()) return {};
    const std::vector<bool> kept = events_kept(state, results);
    const auto shown = static_cast<std::size_t>(std::ranges::count(kept, true));
    const Event& fed = steps.timeline[*state.stepping.fed];
    const std::string& name = tape_of(*steps.story, *fed.place)[fed.place->step].name;
    return fmt::format("Only the {} steps that feed {}: {} are hidden", shown, name.empty() ? fed.what : name,
                       steps_shown(state, results).size() - shown);
}

std::size_t level_now(const ViewerState& state, const Results& results) {
    if (!has_steps(state, results)) return 0;
    const std::vector<StackLine> stack = stack_at(steps_now(state, results), state.step);
    if (stack.empty()) return 0;
    const bool chosen = state.stepping.level_at == state.step;
    if (chosen) return std::min(state.stepping.level, stack.size() - 1);
    // Where a program ended early, its own line tells more than the operation of ours that it called.
    const Steps& steps = steps_now(state, results);
    if (steps.timeline[state.step].stopped_after)
        for (std::size_t level = stack.size(); level-- > 0;)
            if (stack[level].file && is_own(*steps.story, *stack[level].file)) return level;
    return stack.size() - 1;
}

void look_at_level(ViewerState& state, std::size_t level) {
    state.stepping.level = level;
    state.stepping.level_at = state.step;
}

void step_into(ViewerState& state, const Results& results) {
    if (!has_steps(state, results)) return;
    state.playing = false;
    const std::size_t level = level_now(state, results);
    if (level + 1 < stack_at(steps_now(state, results), state.step).size()) look_at_level(state, level + 1);
    else go(state, results, StepTo::forward);
}

void step_over(ViewerState& state, const Results& results) {
    if (!has_steps(state, results)) return;
    const std::size_t level = level_now(state, results);
    const std::vector<StackLine> from = stack_at(steps_now(state, results), state.step);
    go_beyond(state, results, [&](std::size_t common, const std::vector<StackLine>& to) {
        return common <= level || to[level].line != from[level].line || to[level].file != from[level].file;
    });
}

void step_out(ViewerState& state, const Results& results) {
    if (!has_steps(state, results)) return;
    const std::size_t level = level_now(state, results);
    const std::vector<StackLine> from = stack_at(steps_now(state, results), state.step);
    // An operator of vectors is no call of its own on the tape, and is one line.
    if (!from.empty() && from[level].function.starts_with("operator")) return step_over(state, results);
    go_beyond(state, results, [&](std::size_t common, const auto&) { return common <= level; });
}

std::vector<RankedLoss> ranked_losses(const ViewerState& state, const Results& results, std::size_t most) {
    std::vector<RankedLoss> all;
    const Steps& steps = steps_now(state, results);
    if (!steps.story) return all;
    const std::span<const Event> events = steps_shown(state, results);
    for (std::size_t i = 0; i < events.size(); ++i) {
        if (!events[i].place || hides_loss(state, results, i)) continue;
        const Checked& number = tape_of(*steps.story, *events[i].place)[events[i].place->step].checked;
        if (number.own_loss > 0) all.push_back({i, number.own_loss, number.inherited_loss});
    }
    std::ranges::stable_sort(all, [](const RankedLoss& a, const RankedLoss& b) { return a.own > b.own; });
    all.resize(std::min(all.size(), most));
    return all;
}

std::optional<std::size_t> row_to_nudge(const ViewerState& state, const Results& results) {
    if (state.mine.is_stepped || !has_steps(state, results)) return {};
    const Event& event = steps_now(state, results).timeline[state.step];
    std::optional<std::size_t> row = event.place && event.place->row ? event.place->row : event.surface;
    if (!state.stepping.nudges.empty()) row = state.stepping.nudged_row;
    for (std::size_t i = 0; !row && results.story->hit && i < results.story->surfaces.size(); ++i)
        if (results.story->surfaces[i].number == results.story->hit->surface) row = i;
    return row && verdict_is_seen(state, results, *row) ? row : std::nullopt;
}

void nudge(ViewerState& state, const Results& results, const std::string& input, int by) {
    const std::optional<std::size_t> row = row_to_nudge(state, results);
    if (!row || by == 0) return;
    state.stepping.nudged_row = *row;
    state.stepping.nudges.push_back({input, by});
    test_nudged(state, results);
}

void undo_nudge(ViewerState& state, const Results& results) {
    if (state.stepping.nudges.empty() || !results.story || state.mine.is_stepped) return;
    state.stepping.nudges.pop_back();
    test_nudged(state, results);
}

void reset_nudges(ViewerState& state) {
    state.stepping.nudges.clear();
    state.stepping.nudged = nullptr;
}

}  // namespace glassbox
