#pragma once
#include "viewer/model/state/state.hpp"
#include "viewer/model/work/results.hpp"

namespace glassbox {

/// Begins to play the pinned pixel's timeline, from the beginning if it is at its end; or pauses.
void play_or_pause(ViewerState& state, const Results& results);

/// Goes on for so many seconds; the last event stops it.
void go_on_playing(ViewerState& state, const Results& results, double seconds);

}  // namespace glassbox
