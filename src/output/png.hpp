#pragma once
#include <cstddef>
#include <vector>

#include "render/image.hpp"

namespace glassbox {

/// The bytes of a PNG file, 8 bits per channel; always the same for the same picture. Throws Error for a picture
/// without pixels, or of more than 2 GB.
std::vector<std::byte> png(const Image& image);

}  // namespace glassbox
