#pragma once
#include <span>

#include "output/measured.hpp"
#include "render/image.hpp"

namespace glassbox {

/// A picture to project: the coloured channels, pixel for pixel (small ones in whole multiples), each with its name,
/// what it means, the colours' scale, and how many pixels have no value or lie outside the scale. Several measurements
/// stand side by side, in about a square.
Image heat_map(std::span<const Measured> panels);

}  // namespace glassbox
