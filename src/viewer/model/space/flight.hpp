#pragma once

namespace glassbox {

struct ViewerState;

/// Whether the next flight goes back: the camera is near the first hit, or on its way to it.
bool flies_back(const ViewerState& state);

/// Lets the camera in space fly to the first hit, or, where it is near already, back to where all is in sight.
void fly_to_hit_or_back(ViewerState& state);

/// Carries the flight on by that many seconds; `near` is the orbit's distance where the hit's surface is large.
void fly_on(ViewerState& state, double near, double seconds);

}  // namespace glassbox
