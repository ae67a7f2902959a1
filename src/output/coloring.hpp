#pragma once
#include <cstdint>
#include <limits>

#include "output/color_map.hpp"
#include "output/measured.hpp"
#include "render/image.hpp"

namespace glassbox {

/// What a legend says about a plane's values. NaN counts as missing.
struct Summary {
    std::int64_t missing = 0, negative_infinite = 0, positive_infinite = 0;
    double least = std::numeric_limits<double>::infinity();      // of the finite values
    double greatest = -std::numeric_limits<double>::infinity();  // of the finite values
    bool whole = true;                                           // all finite values are whole numbers

    bool any_finite() const { return least <= greatest; }
};

Summary summarized(const Plane& plane);

/// Which value gets which colour.
struct Coloring {
    ColorMap map;
    double low, high;
    bool blocks;  // whole numbers, few: the bar is a row of blocks, one a number

    /// Between the ends: 0 to 1; 0.5 if they are the same.
    double position(double value) const;

    Rgb operator()(double value) const;
};

/// From the fixed range, or from the least to the greatest value; for both signs, 0 is in the middle.
Coloring coloring_of(const Measurement& what, const Summary& summary);

/// Whether it has three components that are shown as red, green and blue.
bool is_direction(const Measured& measured);

/// The planes as colours, a pixel a value, without a legend: what the viewer lays over the picture.
Image colored(const Measured& measured);

}  // namespace glassbox
