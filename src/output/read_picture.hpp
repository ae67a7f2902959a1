#pragma once
#include <filesystem>

#include "render/image.hpp"

namespace glassbox {

/// Reads a picture, PNG or PPM, by its content. 16 bits a channel are cut to 8, grey becomes a colour. Throws Error for
/// a file that is neither, too large, or has a pixel that one can see through.
Image read_picture(const std::filesystem::path& file);

}  // namespace glassbox
