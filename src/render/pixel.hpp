#pragma once
#include <cstddef>

namespace glassbox {

/// A pixel of a picture: (0, 0) is the top-left one.
struct Pixel {
    int x = 0, y = 0;

    bool operator==(const Pixel&) const = default;
};

/// How many pixels a picture has.
constexpr std::size_t pixel_count(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

/// A pixel's place in a list of all, row by row from the top left.
constexpr std::size_t index_of(Pixel pixel, int width) {
    return pixel_count(width, pixel.y) + static_cast<std::size_t>(pixel.x);
}

}  // namespace glassbox
