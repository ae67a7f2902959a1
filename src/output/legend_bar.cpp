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
    if (coloring.low == coloring.high) return coloring.at(0.5);
    const double position = static_cast<double>(column) / (width - 1);
    if (coloring.shown) return coloring(coloring.value_at(position));
    return coloring.at(position);
}

namespace {

Tick tick_at(double value, int digits) { return {value, legend_number(value, digits)}; }

/// Powers of ten, and on a scale for both signs 0 and their negatives; every `apart`th of them.
std::vector<Tick> power_ticks(const Coloring& coloring, int apart) {
    std::vector<Tick> all;
    const bool both = coloring.spacing == Spacing::symlog;
    const double least = both ? coloring.bend : coloring.low;
    const double most = std::max(std::abs(coloring.low), std::abs(coloring.high));
    const int first = static_cast<int>(std::ceil(std::log10(least))), last = static_cast<int>(std::log10(most) + 1);
    const auto add = [&](double value) {
        if (value >= coloring.low && value <= coloring.high) all.push_back(tick_at(value, 1));
    };
    for (int e = last; both && e >= first; --e)
        if ((last - e) % apart == 0) add(-std::pow(10, e));
    if (both) add(0);
    for (int e = first; e <= last; ++e)
        if ((last - e) % apart == 0) add(std::pow(10, e));
    return all;
}

/// At most about that many ticks, where the spacing of the scale wants them.
std::vector<Tick> ticks_of(const Coloring& coloring, int most) {
    std::vector<Tick> all;
    switch (coloring.spacing) {
        case Spacing::linear:
            break;
        case Spacing::log:
        case Spacing::symlog:
            for (int apart = 1; apart < 400; ++apart)
                if (all = power_ticks(coloring, apart); static_cast<int>(all.size()) <= most) break;
            if (all.size() > 1) return all;
            break;
        case Spacing::percentile:
            for (int k = 0; k <= most; ++k) all.push_back(tick_at(coloring.value_at(static_cast<double>(k) / most), 3));
            return all;
    }
    return ticks(coloring.low, coloring.high, most, coloring.blocks);
}

}  // namespace

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
        for (const Tick& tick : ticks_of(coloring, most)) {
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
