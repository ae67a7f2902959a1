#pragma once
#include <array>

#include <rgb.hpp>

namespace glassbox {

/// A row of colours from position 0 to position 1, in steps that look equally large. Lightness alone tells neighbours
/// apart, so that the map stays readable for colour-blind readers and on grey printers.
class ColorMap {
public:
    static constexpr std::size_t steps = 256;  ///< even: position 0.5 has a colour of its own

    explicit ColorMap(const std::array<Rgb, steps + 1>& colors) : colors_(colors) {}

    /// The colour at a position. A position outside [0, 1] gets the colour of the nearer end.
    Rgb operator()(double position) const {
        if (!(position > 0)) return colors_.front();
        if (position >= 1) return colors_.back();
        return colors_[static_cast<std::size_t>(position * steps + 0.5)];
    }

private:
    std::array<Rgb, steps + 1> colors_;
};

/// From dark blue through teal and green to bright yellow: lightness rises from 0.32 to 0.92 (OKLab).
ColorMap sequential_colors();

/// From dark blue (0) through near-white (0.5) to dark orange (1): lightness depends on the distance from 0.5 only.
ColorMap diverging_colors();

/// A direction's components as colour channels: -1 becomes 0, 1 becomes 255.
Rgb direction_color(double x, double y, double z);

/// The colour for no value: nearly black, darker than either map and than any direction.
inline constexpr Rgb no_value_color{20, 20, 20};

}  // namespace glassbox
