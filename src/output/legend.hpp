#pragma once
#include "output/column.hpp"
#include "output/measured.hpp"

namespace glassbox {

/// A measurement's name, its unit and what it means, to stand above its picture; width and text size in pixels.
Column title(const Measurement& what, int width, int size);

/// What its colours mean, to stand below its picture: the scale, the least and the greatest value, and how many pixels
/// have no value or lie outside the scale.
Column legend(const Measured& measured, int width, int size);

}  // namespace glassbox
