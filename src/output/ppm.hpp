#pragma once
#include <cstddef>
#include <vector>

#include "output/origin.hpp"
#include "render/image.hpp"

namespace glassbox {

/// The bytes of a PPM file in its binary form, P6: the simplest picture format. Its origin stands in comments.
std::vector<std::byte> ppm(const Image& image, const Origin& origin = {});

}  // namespace glassbox
