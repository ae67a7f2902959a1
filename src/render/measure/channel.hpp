#pragma once
#include <limits>
#include <string>
#include <vector>

#include "render/pixel.hpp"

namespace glassbox {

/// The value where there is nothing to measure, such as at a pixel whose ray meets no surface.
inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// One number per pixel: row by row, from the top left, like an Image. `no_value` where there is none.
struct Channel {
    std::string name;  ///< as in files: "depth", "n.l", "normal.x"
    int width = 0;
    int height = 0;
    std::vector<double> values;
    std::string why_no_value = {};  ///< for all pixels: "no ray meets a surface"; empty if any has a value

    double at(Pixel pixel) const { return values[index_of(pixel, width)]; }
};

}  // namespace glassbox
