#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "output/measured.hpp"

namespace glassbox {

/// The bytes of an OpenEXR file: each channel under its own name, in 32-bit floats; NaN where there is no value. A
/// double beyond float's range becomes infinite. All channels must have the same size. Throws Error if encoding fails.
std::vector<std::byte> exr(std::span<const Measured> measured);

}  // namespace glassbox
