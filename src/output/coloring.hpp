#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "output/color_map.hpp"
#include "output/measured.hpp"
#include "render/image.hpp"

namespace glassbox {

/// What a legend says about a channel's values. NaN counts as missing.
struct Summary {
    std::int64_t missing = 0, negative_infinite = 0, positive_infinite = 0;
    double least = std::numeric_limits<double>::infinity();           // of the finite values
    double least_positive = std::numeric_limits<double>::infinity();  // of those above 0
    double greatest = -std::numeric_limits<double>::infinity();       // of the finite values
    bool whole = true;                                                // all finite values are whole numbers
    /// 257 values in rising order, as many finite ones between any two neighbours; only if asked for.
    std::vector<double> percentiles = {};

    bool any_finite() const { return least <= greatest; }
};

/// Percentiles, which take longest, are found if that is the spacing. Of more than 2¹⁶ values they are those of a
/// sample.
Summary summarized(const Channel& channel, Spacing spacing = Spacing::linear);

/// The range of a measurement's colours, if the user set one.
using SetRange = std::optional<std::pair<double, double>>;

/// The spacing that is used: words and directions have none but the linear one,
/// differences none that hides a sign.
Spacing spacing_of(const Measurement& what, const SetSpacing& set);

/// Which value gets which colour.
struct Coloring {
    ColorMap map;
    double low, high;
    bool blocks;          // few whole numbers, or words: the bar is a row of blocks, one per number
    SetRange shown = {};  // values outside get a colour of their own; otherwise that of the nearer end
    Spacing spacing = Spacing::linear;
    double bend = 1;                       // of symlog: as far from 0 it is about linear
    std::vector<double> percentiles = {};  // of that spacing: as Summary has them
    bool bright_is_low = false;            // the map's bright end stands for the low values
    double least_above_low = 0;            // what is above `low` has this position at least
    bool marks_0 = false;                  // of a difference: 0 alone has the middle's colour
    Rgb minus_infinity = minus_infinity_color, infinity = infinity_color;

    /// The value's position between the ends, 0 to 1; 0.5 if they are the same.
    double position(double value) const;

    /// The value at a position, from 0 to 1.
    double value_at(double position) const;

    /// The colour at a position.
    Rgb at(double position) const { return map(bright_is_low ? 1 - position : position); }

    /// Values outside these limits count as below or above: the range that was set, or the map's.
    std::pair<double, double> limits() const { return shown.value_or(std::pair(low, high)); }

    /// Values below `limits` that have `below_color`: with a range that was set, or no place on a logarithmic scale.
    bool clips() const { return shown.has_value() || spacing == Spacing::log; }

    Rgb operator()(double value) const;
};

/// Colours the fixed range, or from the least to the greatest value; if they have both signs, 0 is in the middle. A
/// range that was set takes precedence over both; if 0 is in it, 0 stays in the middle of a map for both signs, and
/// otherwise the map for one sign is used. Where there is nothing above 0, a logarithmic scale is a linear one.
Coloring coloring_of(const Measurement& what, const Summary& summary, const SetRange& set = {},
                     const SetSpacing& spacing = {});

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
