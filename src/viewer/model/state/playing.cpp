#include "viewer/model/state/playing.hpp"

#include <algorithm>

#include "viewer/model/story/predicting.hpp"

namespace glassbox {

void play_or_pause(ViewerState& state, const Results& results) {
    if (results.timeline.empty()) return;
    state.playing = !state.playing;
    state.since_step = 0;
    if (state.playing && state.step + 1 >= steps_shown(state, results).size()) state.step = 0;
}

void go_on_playing(ViewerState& state, const Results& results, double seconds) {
    if (!state.playing) return;
    state.since_step += seconds * state.steps_per_second;
    const auto whole = static_cast<std::size_t>(state.since_step);
    state.since_step -= static_cast<double>(whole);
    const std::size_t steps = steps_shown(state, results).size(), last = steps == 0 ? 0 : steps - 1;
    state.step = std::min(state.step + whole, last);
    if (state.step == last) state.playing = false;
}

}  // namespace glassbox
