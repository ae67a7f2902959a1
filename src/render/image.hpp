#pragma once
#include <cstddef>
#include <vector>

#include <rgb.hpp>

namespace glassbox {

/// A picture: pixel (0, 0) is the top-left one, x counts to the right, y down.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<Rgb> pixels;  ///< row by row, from the top

    Image(int w, int h, Rgb fill = {})
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill) {}

    Rgb& at(int x, int y) { return pixels[index(x, y)]; }
    const Rgb& at(int x, int y) const { return pixels[index(x, y)]; }

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

}  // namespace glassbox
