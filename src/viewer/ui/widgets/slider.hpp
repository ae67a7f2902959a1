#pragma once
#include <string>

namespace glassbox {

/// What a slider offers.
struct SliderRange {
    double least = 0, most = 1;
    const char* format = "%.3g";  ///< of its number; one that was dragged is rounded as it is written
    bool is_logarithmic = false;
};

/// A slider as wide as there is room, but for `room_on_right`, below a line with its name and its number: a handle
/// covers neither. Returns whether `value` was changed. `id` tells it from other sliders.
bool slider(const char* id, const std::string& name, double& value, const SliderRange& range, float room_on_right = 0);

}  // namespace glassbox
