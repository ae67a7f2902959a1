#pragma once
#include "viewer/model/state/state.hpp"
#include "viewer/model/work/results.hpp"

namespace glassbox {

/// Starts playing the pinned pixel's timeline, from the beginning if it is at its end; or pauses.
void play_or_pause(ViewerState& state, const Results& results);

/// Continues for so many seconds; stops at the last event that may be seen.
void go_on_playing(ViewerState& state, const Results& results, double seconds);

}  // namespace glassbox
