#pragma once
#include <cstddef>
#include <optional>

#include "viewer/model/state/state.hpp"
#include "viewer/model/work/results.hpp"

namespace glassbox {

/// Returns the number of the surface that is lit up wherever it is shown: what the mouse points at in any part of the
/// window, or else, on the page *Steps*, the one that the present step is about.
std::optional<std::size_t> lit_surface(const ViewerState& state, const Results& results);

/// The same, as the story lists it; null if it is not listed.
const story::Surface* lit_in_story(const ViewerState& state, const Results& results);

/// Begins a frame: what was pointed at in the one before is lit in this one.
void begin_pointing(ViewerState& state);

}  // namespace glassbox
