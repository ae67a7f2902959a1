#include "output/coloring.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace glassbox {

Summary summarized(const Channel& channel) {
    Summary all;
    for (const double v : channel.values) {
        if (std::isnan(v)) ++all.missing;
        else if (std::isinf(v)) ++(v > 0 ? all.positive_infinite : all.negative_infinite);
        else {
            all.least = std::min(all.least, v);
            all.greatest = std::max(all.greatest, v);
            all.whole = all.whole && v == std::floor(v);
        }
    }
    return all;
}

double Coloring::position(double value) const {
    if (value < low) return 0;
    if (value > high) return 1;
    if (low == high) return 0.5;
    // Scaled to about 1 first: 1e308 - -1e308 would be infinite, and 5e-324 has no half.
    const int e = -std::max(std::ilogb(low), std::ilogb(high)) - 1;
    const double from = std::ldexp(low, e);
    return (std::ldexp(value, e) - from) / (std::ldexp(high, e) - from);
}

Rgb Coloring::operator()(double value) const {
    if (std::isnan(value)) return no_value_color;
    if (shown && value < shown->first) return below_color;
    if (shown && value > shown->second) return above_color;
    return map(position(value));
}

Coloring coloring_of(const Measurement& what, const Summary& summary, const SetRange& set) {
    double low = summary.any_finite() ? summary.least : 0;
    double high = summary.any_finite() ? summary.greatest : 0;
    if (what.range) std::tie(low, high) = *what.range;
    if (set) std::tie(low, high) = *set;
    const auto is_whole = [](double value) { return value == std::floor(value); };
    const bool counted =
        set ? is_whole(low) && is_whole(high) : !what.range || (what.scale == Scale::sequential && is_whole(high));
    const bool diverging = what.scale == Scale::diverging && low <= 0 && 0 <= high;
    if (diverging) {
        high = std::max(std::abs(low), std::abs(high));
        low = -high;
    }
    const bool blocks = counted && summary.any_finite() && summary.whole && high - low < 20;
    return {diverging ? diverging_colors() : sequential_colors(), low, high, blocks, set};
}

Outside outside(const Channel& channel, const Coloring& coloring) {
    const auto [low, high] = coloring.limits();
    Outside counts;
    for (const double value : channel.values) {
        if (!std::isfinite(value)) continue;
        counts.below += value < low;
        counts.above += value > high;
    }
    return counts;
}

bool is_direction(const Measured& measured) {
    return measured.what->scale == Scale::direction && measured.channels.size() == 3;
}

namespace {

/// Draws a contour in white with black beside it, visible on any colour: at the values from `level` on that have a
/// lower one next to them.
void draw_contour(Image& image, const Channel& channel, double level) {
    const auto above = [&](int x, int y) { return channel.at({x, y}) >= level; };
    for (int y = 0; y + 1 < channel.height; ++y)
        for (int x = 0; x + 1 < channel.width; ++x) {
            if (above(x, y) == above(x + 1, y) && above(x, y) == above(x, y + 1)) continue;
            image.at(x, y) = {255, 255, 255};
            image.at(x + 1, y + 1) = {0, 0, 0};
        }
}

}  // namespace

Image colored(const Measured& measured, const SetRange& set) {
    const Channel& first = measured.channels.front();
    Image image(first.width, first.height, no_value_color);
    if (is_direction(measured)) {
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            const double x = first.values[i], y = measured.channels[1].values[i], z = measured.channels[2].values[i];
            if (!std::isnan(x) && !std::isnan(y) && !std::isnan(z)) image.pixels[i] = direction_color(x, y, z);
        }
    } else {
        const Coloring coloring = coloring_of(*measured.what, summarized(first), set);
        std::transform(first.values.begin(), first.values.end(), image.pixels.begin(), coloring);
        if (measured.what->contour) draw_contour(image, first, *measured.what->contour);
    }
    return image;
}

}  // namespace glassbox
