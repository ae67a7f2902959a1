#pragma once
#include "render/image.hpp"

namespace glassbox {

// To put a sheet together from pictures.

/// Copies a picture to where its top left corner is to be; it must fit.
void paste(Image& onto, const Image& picture, int x, int y);

/// Each pixel as a square of `factor` pixels.
Image enlarged(const Image& image, int factor);

/// The factor for small pictures, so that the longer side has 200 pixels and each pixel stays a square; else 1.
int enlargement(int width, int height);

}  // namespace glassbox
