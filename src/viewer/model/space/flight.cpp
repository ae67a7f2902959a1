#include "viewer/model/space/flight.hpp"

#include <algorithm>
#include <cmath>

#include "viewer/model/state/state.hpp"

namespace glassbox {

namespace {

constexpr double flight_seconds = .5;
constexpr double near_enough = .7;  // of the distance at which all is in sight: then a flight goes back

/// Slow at both ends.
double eased(double part) { return part * part * (3 - 2 * part); }

}  // namespace

bool flies_back(const ViewerState& state) {
    return state.flight ? state.flight->to_hit : state.orbit.distance < near_enough;
}

void fly_to_hit_or_back(ViewerState& state) {
    state.space_shown = true;
    state.flight = Flight{.to_hit = !flies_back(state), .from = state.orbit};
}

void fly_on(ViewerState& state, double near, double seconds) {
    if (!state.flight) return;
    Flight& flight = *state.flight;
    flight.elapsed += seconds;
    const double part = eased(std::clamp(flight.elapsed / flight_seconds, 0.0, 1.0));
    const double target = flight.to_hit ? near : 1;
    // By equal factors in equal times, as the wheel does.
    state.orbit.distance = flight.from.distance * std::pow(target / flight.from.distance, part);
    state.orbit.pan = {flight.from.pan.x * (1 - part), flight.from.pan.y * (1 - part)};
    if (part < 1) return;
    state.orbit.distance = target;
    state.orbit.pan = {};
    state.flight.reset();
}

}  // namespace glassbox
