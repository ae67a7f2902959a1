#pragma once
#include <cstddef>
#include <vector>

#include "output/origin.hpp"
#include "render/image.hpp"

namespace glassbox {

/// The bytes of a PNG file, 8 bits per channel, with its origin in chunks of text (tEXt, iTXt); always the same for the
/// same picture and origin. Throws Error for a picture without pixels, or of more than 2 GB.
std::vector<std::byte> png(const Image& image, const Origin& origin = {});

}  // namespace glassbox
