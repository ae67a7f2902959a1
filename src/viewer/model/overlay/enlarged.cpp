#include "viewer/model/overlay/enlarged.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glassbox {

int side_to_be_seen(double zoom) {
    constexpr double least = 3;  // of the screen's pixels
    return zoom >= least ? 1 : static_cast<int>(std::ceil(least / zoom));
}

std::vector<std::uint32_t> enlarged(std::span<const std::uint8_t> ranks, std::size_t width, int side) {
    std::vector<std::uint32_t> drawn(ranks.size());
    std::iota(drawn.begin(), drawn.end(), 0u);
    if (width == 0 || side <= 1) return drawn;
    const std::size_t height = ranks.size() / width;

    const auto none = static_cast<std::uint32_t>(ranks.size());  // what lies beside the picture
    const auto rank = [&](std::uint32_t pixel) { return pixel == none ? 0 : ranks[pixel]; };
    const auto higher = [&](std::uint32_t a, std::uint32_t b) { return rank(b) > rank(a) ? b : a; };
    const auto reach = static_cast<std::size_t>(side), before = reach / 2;
    std::vector<std::uint32_t> line;
    // The highest of `reach` neighbours in a line, by way of the highest of 2, of 4, of 8 … of them.
    const auto spread = [&](std::size_t first, std::size_t stride, std::size_t count) {
        line.assign(count + reach, none);
        for (std::size_t k = 0; k < count; ++k) line[before + k] = drawn[first + stride * k];
        std::size_t window = 1;
        for (; 2 * window <= reach; window *= 2)
            for (std::size_t k = 0; k + window < line.size(); ++k) line[k] = higher(line[k], line[k + window]);
        for (std::size_t k = 0; k < count; ++k) {
            std::uint32_t& here = drawn[first + stride * k];
            here = higher(here, higher(line[k], line[k + reach - window]));
        }
    };
    for (std::size_t y = 0; y < height; ++y) spread(y * width, 1, width);
    for (std::size_t x = 0; x < width; ++x) spread(x, width, height);
    return drawn;
}

}  // namespace glassbox
