#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "output/color_map.hpp"
#include "output/measured.hpp"
#include "render/image.hpp"

namespace glassbox {

/// What a legend says about a channel's values. NaN counts as missing.
struct Summary {
    std::int64_t missing = 0, negative_infinite = 0, positive_infinite = 0;
    double least = std::numeric_limits<double>::infinity();      // of the finite values
    double greatest = -std::numeric_limits<double>::infinity();  // of the finite values
    bool whole = true;                                           // all finite values are whole numbers

    bool any_finite() const { return least <= greatest; }
};

Summary summarized(const Channel& channel);

/// The range of a measurement's colours that somebody set.
using SetRange = std::optional<std::pair<double, double>>;

/// What lies outside a range that was set: two purples that neither map has, and that lightness tells apart.
inline constexpr Rgb below_color{96, 0, 110}, above_color{255, 70, 225};

/// Which value gets which colour.
struct Coloring {
    ColorMap map;
    double low, high;
    bool blocks;          // whole numbers, few: the bar is a row of blocks, one a number
    SetRange shown = {};  // what lies outside has a colour of its own; otherwise that of the nearer end

    /// Between the ends: 0 to 1; 0.5 if they are the same.
    double position(double value) const;

    /// What lies outside this counts as below or above: the range that was set, or the map's.
    std::pair<double, double> limits() const { return shown.value_or(std::pair(low, high)); }

    Rgb operator()(double value) const;
};

/// From the fixed range, or from the least to the greatest value; if they have both signs, 0 is in the middle. A range
/// that was set comes before both; if 0 is in it, it stays in the middle of a map for both signs, and otherwise one
/// sign's map will do.
Coloring coloring_of(const Measurement& what, const Summary& summary, const SetRange& set = {});

/// How many finite values lie outside the limits.
struct Outside {
    std::int64_t below = 0, above = 0;
};

Outside outside(const Channel& channel, const Coloring& coloring);

/// Whether it has three components that are shown as red, green and blue.
bool is_direction(const Measured& measured);

/// The channels as colours, a pixel a value, without a legend: what the viewer lays over the picture.
Image colored(const Measured& measured, const SetRange& set = {});

}  // namespace glassbox
