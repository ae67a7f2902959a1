#include "output/coloring.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>
#include <utility>

namespace glassbox {

namespace {

/// As many of the finite values as ColorMap has steps, evenly among them in rising order.
std::vector<double> percentiles_of(const Channel& channel) {
    constexpr std::size_t most = std::size_t{1} << 16;
    const std::size_t stride = (channel.values.size() + most - 1) / most;
    std::vector<double> sample;
    for (std::size_t i = 0; i < channel.values.size(); i += stride)
        if (std::isfinite(channel.values[i])) sample.push_back(channel.values[i]);
    std::sort(sample.begin(), sample.end());
    std::vector<double> result;
    for (std::size_t k = 0; k <= ColorMap::steps && !sample.empty(); ++k)
        result.push_back(sample[k * (sample.size() - 1) / ColorMap::steps]);
    return result;
}

/// Where value lies from `low` to `high`.
double share(double low, double high, double value) {
    if (const double width = high - low; std::isnormal(width)) return (value - low) / width;
    // Scaled to about 1 first: 1e308 - -1e308 is infinite, and 5e-324 has no half.
    const int e = -std::max(std::ilogb(low), std::ilogb(high)) - 1;
    const double from = std::ldexp(low, e);
    return (std::ldexp(value, e) - from) / (std::ldexp(high, e) - from);
}

}  // namespace

Summary summarized(const Channel& channel, Spacing spacing) {
    Summary all;
    for (const double v : channel.values) {
        if (std::isnan(v)) ++all.missing;
        else if (std::isinf(v)) ++(v > 0 ? all.positive_infinite : all.negative_infinite);
        else {
            all.least = std::min(all.least, v);
            all.greatest = std::max(all.greatest, v);
            if (v > 0) all.least_positive = std::min(all.least_positive, v);
            all.whole = all.whole && v == std::floor(v);
        }
    }
    if (spacing == Spacing::percentile) all.percentiles = percentiles_of(channel);
    if (!all.percentiles.empty()) {
        all.percentiles.front() = all.least;
        all.percentiles.back() = all.greatest;
    }
    return all;
}

Spacing spacing_of(const Measurement& what, const SetSpacing& set) {
    const bool fixed = what.scale == Scale::direction || what.scale == Scale::words;
    if (fixed) return Spacing::linear;
    const Spacing spacing = set.value_or(what.spacing);
    if (what.scale == Scale::difference && spacing != Spacing::linear) return Spacing::symlog;
    return spacing;
}

double Coloring::position(double value) const {
    if (value < low) return 0;
    if (value > high) return 1;
    if (low == high) return 0.5;
    const auto bent = [this](double v) { return std::asinh(v / bend); };
    switch (spacing) {
        case Spacing::linear:
            break;
        case Spacing::log:
            return std::clamp(std::log(value / low) / std::log(high / low), 0.0, 1.0);
        case Spacing::symlog:
            return std::clamp((bent(value) - bent(low)) / (bent(high) - bent(low)), 0.0, 1.0);
        case Spacing::percentile: {
            // Of equal ones the middle.
            const auto [first, end] = std::equal_range(percentiles.begin(), percentiles.end(), value);
            const auto before = static_cast<double>(first - percentiles.begin());
            const auto after = static_cast<double>(end - percentiles.begin()) - 1;
            return std::clamp((before + after) / 2 / static_cast<double>(percentiles.size() - 1), 0.0, 1.0);
        }
    }
    return share(low, high, value);
}

double Coloring::value_at(double place) const {
    if (!(place > 0)) return low;
    if (place >= 1) return high;
    switch (spacing) {
        case Spacing::linear:
            break;
        case Spacing::log:
            return std::clamp(low * std::pow(high / low, place), low, high);
        case Spacing::symlog:
            return std::clamp(bend * std::sinh(std::lerp(std::asinh(low / bend), std::asinh(high / bend), place)), low,
                              high);
        case Spacing::percentile:
            return percentiles[static_cast<std::size_t>(
                std::lround(place * static_cast<double>(percentiles.size() - 1)))];
    }
    return std::lerp(low, high, place);
}

Rgb Coloring::operator()(double value) const {
    if (std::isnan(value)) return no_value_color;
    if (std::isinf(value)) return value > 0 ? infinity : minus_infinity;
    if (clips() && value < limits().first) return below_color;
    if (clips() && value > limits().second) return above_color;
    if (marks_0 && value != 0) {
        constexpr double aside = 0.5 + 1.0 / ColorMap::steps;
        return at(value > 0 ? std::max(position(value), aside) : std::min(position(value), 1 - aside));
    }
    return at(value > low ? std::max(position(value), least_above_low) : position(value));
}

namespace {

ColorMap map_of(const Measurement& what, bool both_signs) {
    switch (what.scale) {
        case Scale::danger:
            return danger_colors();
        case Scale::alarm:
            return alarm_colors();
        case Scale::words:
            return word_colors(what.words.size());
        case Scale::difference:
            if (both_signs) return difference_colors();
            break;
        case Scale::sequential:
        case Scale::diverging:
        case Scale::direction:
            break;
    }
    return both_signs ? diverging_colors() : sequential_colors();
}

/// As the spacing wants it, if the values allow it.
Coloring spaced(Coloring coloring, Spacing spacing, const Summary& summary) {
    // Beyond that the logarithm of a ratio, or its quotient, overflows.
    constexpr double least = 1e-150, most = 1e150;
    const double largest = std::max(std::abs(coloring.low), std::abs(coloring.high));
    if (!(coloring.low < coloring.high) || !(largest >= least && largest <= most)) return coloring;
    switch (spacing) {
        case Spacing::linear:
            return coloring;
        case Spacing::log: {
            const double from = coloring.low > 0 ? coloring.low : summary.least_positive;
            if (!(from < coloring.high)) return coloring;
            coloring.low = std::max(from, least);
            if (coloring.shown) coloring.shown->first = std::max(coloring.shown->first, coloring.low);
            break;
        }
        case Spacing::symlog:
            coloring.bend = largest / 1e4;
            break;
        case Spacing::percentile:
            if (summary.percentiles.empty()) return coloring;
            coloring.percentiles = summary.percentiles;
            std::tie(coloring.low, coloring.high) = std::pair(summary.percentiles.front(), summary.percentiles.back());
            coloring.shown.reset();
            break;
    }
    coloring.blocks = false;
    coloring.spacing = spacing;
    return coloring;
}

}  // namespace

Coloring coloring_of(const Measurement& what, const Summary& summary, const SetRange& set, const SetSpacing& spacing) {
    double low = summary.any_finite() ? summary.least : 0;
    double high = summary.any_finite() ? summary.greatest : 0;
    if (what.scale == Scale::alarm) low = std::min(low, 0.0);  // so that one above 0 is never taken for safe
    if (what.range) std::tie(low, high) = *what.range;
    if (set) std::tie(low, high) = *set;
    const auto is_whole = [](double value) { return value == std::floor(value); };
    const bool counted =
        set ? is_whole(low) && is_whole(high) : !what.range || (what.scale == Scale::sequential && is_whole(high));
    // A map for both signs needs 0 in its middle.
    const Spacing chosen = spacing_of(what, spacing);
    const bool two_sided = chosen == Spacing::linear || chosen == Spacing::symlog;
    const bool centred = what.scale == Scale::diverging || what.scale == Scale::difference;
    const bool diverging = centred && two_sided && low <= 0 && 0 <= high;
    if (diverging) {
        high = std::max(std::abs(low), std::abs(high));
        low = -high;
    }
    const bool few = counted && summary.any_finite() && summary.whole && high - low < 20;
    Coloring coloring{map_of(what, diverging), low, high, few || what.scale == Scale::words, set};
    if (what.scale == Scale::danger) {
        coloring.bright_is_low = what.worst == Worst::least;
        coloring.minus_infinity = danger_minus_infinity_color;
        coloring.infinity = danger_infinity_color;
    }
    coloring.marks_0 = what.scale == Scale::difference && diverging;
    if (what.scale == Scale::alarm) coloring.least_above_low = 1.0 / ColorMap::steps;
    coloring = spaced(std::move(coloring), chosen, summary);
    if (what.alarm == Alarm::below_0 && coloring.low < 0 && coloring.high > 0)
        coloring.map = danger_colors(1 - coloring.position(0));
    return coloring;
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
        const Summary summary = summarized(first, spacing_of(*measured.what, measured.spacing));
        const Coloring coloring = coloring_of(*measured.what, summary, set, measured.spacing);
        std::ranges::transform(first.values, image.pixels.begin(), std::cref(coloring));
        if (measured.what->contour) draw_contour(image, first, *measured.what->contour);
    }
    return image;
}

}  // namespace glassbox
