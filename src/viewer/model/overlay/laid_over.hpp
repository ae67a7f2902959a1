#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "viewer/model/state/state.hpp"
#include "viewer/model/work/results.hpp"

namespace glassbox {

/// The chosen measurement of this scene, as long as nothing newer is there: perhaps of another setup, or coarse. Null
/// while there is none.
const MeasuredChannels* last_laid_over(const ViewerState& state, const Results& results);

/// What is measured of what the state shows, perhaps coarsely; null while there is none, or only what was measured of
/// something else.
const MeasuredChannels* laid_over(const ViewerState& state, const Results& results);

/// The same, if it has all pixels.
const MeasuredChannels* wholly_laid_over(const ViewerState& state, const Results& results);

/// Pins the next of the overlay's worst pixels, or the one before, and brings it into view. Where nothing is laid over
/// the picture, `verdict` is.
void pin_next_worst(ViewerState& state, const Results& results, bool forward);

/// Pins a pixel, and brings it into view.
void pin_in_view(ViewerState& state, Pixel pixel);

/// The brush, if it is one of the measurement that is laid over the picture.
const Brush* brush_of(const Overlay& overlay);

/// Whether that value is brushed.
bool is_brushed(const Brush& brush, double value);

/// The ranks of the pixels that must be seen at any zoom, 0 for the others: the brushed ones, all alike; without a
/// brush those that raise an alarm, the worse the higher.
std::vector<std::uint8_t> ranks_of(const Measurement& what, const Channel& channel, const Overlay& overlay);

/// "undecided" or "wrong": what its alarms tell of a pixel.
std::string_view alarm_word(const Measurement& what);

}  // namespace glassbox
