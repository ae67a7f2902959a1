#include "output/color_map.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "output/oklab.hpp"

namespace glassbox {
namespace {

// Our choice of both curves stays inside sRGB's gamut; a colour clamped to it would bend them.

OkLab sequential_curve(double t) {
    const double chroma = std::min(0.17, 0.085 + 0.5 * (t - 0.3) * (t - 0.3));
    return oklch(0.32 + 0.60 * t, chroma, 268 - 163 * t);
}

OkLab diverging_curve(double t) {
    const double d = std::abs(2 * t - 1);
    return oklch(0.96 - 0.58 * d, 0.42 * d * (1 - d) + 0.085 * d * d, t < 0.5 ? 255 : 50);
}

OkLab danger_curve(double t) {
    const OkLab safe = oklch(0.30, 0.08, 262), bad = oklch(0.95, 0.175, 105);
    return {std::lerp(safe.lightness, bad.lightness, t), std::lerp(safe.a, bad.a, t), std::lerp(safe.b, bad.b, t)};
}

OkLab alarm_curve(double t) { return danger_curve(0.55 + 0.45 * t); }

/// The curve's colours at equal distances along it, rather than at equal steps of its parameter.
ColorMap evenly(OkLab (*curve)(double)) {
    constexpr std::size_t fine = 16 * ColorMap::steps;
    std::vector<double> length(fine + 1);  // from the start of the curve to each of its fine points
    for (std::size_t i = 1; i <= fine; ++i)
        length[i] =
            length[i - 1] + difference(curve(static_cast<double>(i - 1) / fine), curve(static_cast<double>(i) / fine));

    std::array<Rgb, ColorMap::steps + 1> colors;
    for (std::size_t i = 0; i <= ColorMap::steps; ++i) {
        const double wanted = length.back() * static_cast<double>(i) / ColorMap::steps;
        const auto next = std::lower_bound(length.begin() + 1, length.end() - 1, wanted);
        const double before = *(next - 1);
        const double parameter = static_cast<double>(next - length.begin() - 1) + (wanted - before) / (*next - before);
        colors[i] = to_rgb(curve(parameter / fine));
    }
    return ColorMap(colors);
}

}  // namespace

ColorMap sequential_colors() { return evenly(sequential_curve); }
ColorMap diverging_colors() { return evenly(diverging_curve); }

ColorMap difference_colors() {
    const ColorMap whole = evenly(diverging_curve);
    constexpr std::size_t middle = ColorMap::steps / 2;
    constexpr double left_out = 0.12;  // on either side of the middle
    std::array<Rgb, ColorMap::steps + 1> colors{};
    colors[middle] = whole(0.5);
    for (std::size_t i = 1; i <= middle; ++i) {
        const double aside = std::lerp(left_out, 0.5, static_cast<double>(i - 1) / (middle - 1));
        colors[middle - i] = whole(0.5 - aside);
        colors[middle + i] = whole(0.5 + aside);
    }
    return ColorMap(colors);
}

ColorMap danger_colors(double alarm) {
    const ColorMap whole = evenly(danger_curve);
    if (alarm >= 1) return whole;
    constexpr double calm = 0.6, bright = 0.85;  // the parts of the whole map below and above the step
    std::array<Rgb, ColorMap::steps + 1> colors{};
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const double t = static_cast<double>(i) / ColorMap::steps;
        colors[i] = whole(t > alarm   ? std::lerp(bright, 1, (t - alarm) / (1 - alarm))
                          : alarm > 0 ? calm * t / alarm
                                      : 0);
    }
    return ColorMap(colors);
}

ColorMap alarm_colors() {
    const ColorMap bright = evenly(alarm_curve);
    std::array<Rgb, ColorMap::steps + 1> colors{danger_colors()(0)};
    for (std::size_t i = 1; i < colors.size(); ++i) colors[i] = bright(static_cast<double>(i) / ColorMap::steps);
    return ColorMap(colors);
}

ColorMap word_colors(std::size_t words) {
    const Rgb some[] = {danger_colors()(0), {255, 140, 30}, {95, 195, 255}, {250, 235, 70}};
    std::array<Rgb, ColorMap::steps + 1> colors{};
    for (std::size_t i = 0; i < colors.size(); ++i)
        colors[i] =
            some[std::min((2 * i * (words - 1) + ColorMap::steps) / (2 * ColorMap::steps), std::size(some) - 1)];
    return ColorMap(colors);
}

Rgb direction_color(double x, double y, double z) {
    const auto channel = [](double component) { return rounded_byte(127.5 * (component + 1)); };
    return {channel(x), channel(y), channel(z)};
}

}  // namespace glassbox
