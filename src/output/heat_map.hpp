#pragma once
#include <span>

#include "output/measured.hpp"
#include "render/image.hpp"

namespace glassbox {

/// A picture to project: the coloured channels, pixel for pixel (small ones in whole multiples), each with its name,
/// its meaning, the colour scale, and how many pixels have no value or lie outside the scale. Several measurements are
/// arranged in about a square.
Image heat_map(std::span<const Measured> panels);

}  // namespace glassbox
