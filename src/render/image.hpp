#pragma once
#include <vector>

#include <rgb.hpp>

#include "render/pixel.hpp"

namespace glassbox {

/// A picture: pixel (0, 0) is the top-left one, x counts to the right, y down.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<Rgb> pixels;  ///< row by row, from the top

    Image(int w, int h, Rgb fill = {}) : width(w), height(h), pixels(pixel_count(w, h), fill) {}

    Rgb& at(int x, int y) { return pixels[index_of({x, y}, width)]; }
    const Rgb& at(int x, int y) const { return pixels[index_of({x, y}, width)]; }
};

}  // namespace glassbox
