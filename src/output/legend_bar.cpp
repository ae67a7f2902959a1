#include "output/legend_bar.hpp"

#include <algorithm>
#include <cmath>

#include "output/legend_number.hpp"

namespace glassbox {

int place_on_bar(const Coloring& coloring, double value, int width) {
    double position = coloring.position(value);
    if (coloring.blocks) position = (value - coloring.low + 0.5) / (coloring.high - coloring.low + 1);
    return static_cast<int>(std::lround(position * (width - 1)));
}

Rgb color_on_bar(const Coloring& coloring, int column, int width) {
    if (coloring.blocks) {
        const double numbers = coloring.high - coloring.low + 1;
        return coloring(coloring.low + std::floor(column * numbers / width));
    }
    if (coloring.low == coloring.high) return coloring.map(0.5);
    const double position = static_cast<double>(column) / (width - 1);
    if (coloring.shown) return coloring(std::lerp(coloring.low, coloring.high, position));
    return coloring.map(position);
}

std::vector<PlacedTick> placed_ticks(const Coloring& coloring, int width, int size,
                                     const std::function<int(const std::string&)>& text_width) {
    if (coloring.low == coloring.high) {
        const std::string text = legend_number(coloring.low, 6);
        const int half = text_width(text) / 2;
        return {{width / 2, std::max(0, width / 2 - half), text}};
    }
    for (int most = std::max(2, width / (3 * size)); most >= 1; --most) {
        std::vector<PlacedTick> labels;
        bool apart = true;
        int end_of_last = -size;
        for (const Tick& tick : ticks(coloring.low, coloring.high, most, coloring.blocks)) {
            const int mark = place_on_bar(coloring, tick.value, width);
            const int label_width = text_width(tick.label);
            const int left = std::clamp(mark - label_width / 2, 0, std::max(0, width - label_width));
            apart = apart && left >= end_of_last + size / 2 && label_width <= width;
            end_of_last = left + label_width;
            labels.push_back({mark, left, tick.label});
        }
        if (apart) return labels;
    }
    return {};
}

}  // namespace glassbox
