#pragma once
#include <limits>
#include <string>
#include <vector>

namespace glassbox {

/// A measurement where there is nothing to measure, at a pixel that meets no surface, say.
inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// One number a pixel: row by row, from the top left, like an Image. `no_value` where there is none.
struct Channel {
    std::string name;  ///< as in files: "depth", "n.l", "normal.x"
    int width = 0;
    int height = 0;
    std::vector<double> values;
    std::string why_no_value = {};  ///< of all pixels: "no ray meets a surface"; empty where one has a value
};

}  // namespace glassbox
