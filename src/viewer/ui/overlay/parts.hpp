#pragma once
#include <string>

#include "viewer/ui/panels.hpp"

namespace glassbox {

// The parts of the overlay's page, one below the other.

void draw_measurement_list(const Frame& frame);
void draw_minus(const Frame& frame);   ///< what is subtracted from the measurement
void draw_legend(const Frame& frame);  ///< opacity, range, what the colours stand for, and how often

/// The values of one component, above its bar of colours; dragging over it brushes them. `axis` is 0 to 2 for a
/// direction's x, y, z, and -1 otherwise.
void draw_histogram(const Frame& frame, int axis);

/// The worst, the least and the greatest values' pixels; a click pins one.
void draw_found(const Frame& frame, const MeasuredChannels& measured);

void draw_beside(const Frame& frame);

/// A square of that colour, and what it stands for.
void swatch(Rgb color, const std::string& text);

/// Text in a faint colour, wrapped.
void faint(const Frame& frame, std::string_view text);

}  // namespace glassbox
