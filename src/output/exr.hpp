#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "output/measured.hpp"
#include "output/origin.hpp"

namespace glassbox {

/// The bytes of an OpenEXR file: each channel under its own name, in 32-bit floats; NaN where there is no value. A
/// double beyond float's range becomes infinite. Its origin stands in attributes of type string, `software` and
/// `command`. All channels must have the same size. Throws Error if encoding fails.
std::vector<std::byte> exr(std::span<const Measured> measured, const Origin& origin = {});

}  // namespace glassbox
