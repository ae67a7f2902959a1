#include "viewer/model/state/playing.hpp"

#include <algorithm>

#include "viewer/model/story/predicting.hpp"
#include "viewer/model/story/stepping.hpp"
#include "viewer/model/story/steps_now.hpp"

namespace glassbox {

void play_or_pause(ViewerState& state, const Results& results) {
    if (steps_now(state, results).timeline.empty()) return;
    state.playing = !state.playing;
    state.since_step = 0;
    const auto at = [&](StepTo to) {
        return stepped(steps_shown(state, results), state.step, to, events_kept(state, results));
    };
    if (state.playing && state.step >= at(StepTo::last)) state.step = at(StepTo::first);
}

void go_on_playing(ViewerState& state, const Results& results, double seconds) {
    if (!state.playing) return;
    state.since_step += seconds * state.steps_per_second;
    const auto whole = static_cast<std::size_t>(state.since_step);
    state.since_step -= static_cast<double>(whole);
    const std::span<const Event> events = steps_shown(state, results);
    const std::vector<bool> kept = events_kept(state, results);
    const std::size_t last = stepped(events, state.step, StepTo::last, kept);
    for (std::size_t i = 0; i < whole && state.step < last; ++i)
        state.step = stepped(events, state.step, StepTo::forward, kept);
    if (state.step >= last) state.playing = false;
}

}  // namespace glassbox
