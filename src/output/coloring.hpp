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

/// The range of a measurement's colours, if the user set one.
using SetRange = std::optional<std::pair<double, double>>;

/// The colours for values outside a set range: two purples that neither map has, and that lightness tells apart.
inline constexpr Rgb below_color{96, 0, 110}, above_color{255, 70, 225};

/// Which value gets which colour.
struct Coloring {
    ColorMap map;
    double low, high;
    bool blocks;          // few whole numbers: the bar is a row of blocks, one per number
    SetRange shown = {};  // values outside get a colour of their own; otherwise that of the nearer end

    /// The value's position between the ends, 0 to 1; 0.5 if they are the same.
    double position(double value) const;

    /// Values outside these limits count as below or above: the range that was set, or the map's.
    std::pair<double, double> limits() const { return shown.value_or(std::pair(low, high)); }

    Rgb operator()(double value) const;
};

/// Colours the fixed range, or from the least to the greatest value; if they have both signs, 0 is in the middle. A
/// range that was set takes precedence over both; if 0 is in it, 0 stays in the middle of a map for both signs, and
/// otherwise the map for one sign is used.
Coloring coloring_of(const Measurement& what, const Summary& summary, const SetRange& set = {});

/// How many finite values lie outside the limits.
struct Outside {
    std::int64_t below = 0, above = 0;
};

Outside outside(const Channel& channel, const Coloring& coloring);

/// Whether the measurement has three components that are shown as red, green and blue.
bool is_direction(const Measured& measured);

/// The channels as colours, one pixel per value, without a legend: the viewer's overlay.
Image colored(const Measured& measured, const SetRange& set = {});

}  // namespace glassbox
