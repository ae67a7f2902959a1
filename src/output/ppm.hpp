#pragma once
#include <cstddef>
#include <vector>

#include "render/image.hpp"

namespace glassbox {

/// The bytes of a PPM file in its binary form, P6: the simplest picture format.
std::vector<std::byte> ppm(const Image& image);

}  // namespace glassbox
