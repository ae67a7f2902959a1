#pragma once
#include "output/column.hpp"
#include "output/measured.hpp"

namespace glassbox {

/// A measurement's name, unit and meaning, to be shown above its picture; width and text size in pixels.
Column title(const Measurement& what, int width, int size);

/// The meaning of its colours, to be shown below its picture: the scale, the least and the greatest value, and how many
/// pixels have no value or lie outside the scale.
Column legend(const Measured& measured, int width, int size);

}  // namespace glassbox
