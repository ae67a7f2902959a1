#include "viewer/model/overlay/difference.hpp"

#include <algorithm>
#include <cstdlib>

namespace glassbox {

Difference picture_difference(const Image& one, const Image& other) {
    Difference result{Image(one.width, one.height)};
    const auto magnified = [](int channel) {
        return static_cast<std::uint8_t>(std::min(255, Difference::magnification * channel));
    };
    for (int y = 0; y < one.height; ++y)
        for (int x = 0; x < one.width; ++x) {
            const Rgb a = one.at(x, y), b = other.at(x, y);
            const int red = std::abs(a.red - b.red), green = std::abs(a.green - b.green),
                      blue = std::abs(a.blue - b.blue);
            const int most = std::max({red, green, blue});
            result.magnified.at(x, y) = {magnified(red), magnified(green), magnified(blue)};
            result.pixels += most > 0;
            if (most <= result.greatest) continue;
            result.greatest = most;
            result.where = {x, y};
        }
    return result;
}

}  // namespace glassbox
