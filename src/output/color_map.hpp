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

/// The same three, without the palest: whatever is not in the very middle is blue or orange at sight.
ColorMap difference_colors();

/// From dark blue-grey, where it is safe, through grey to bright yellow: the colours of danger. Lightness rises from
/// 0.3 to 0.95, with a step at `alarm`, from where on all is bright.
ColorMap danger_colors(double alarm = 1);

/// The darkest of these at position 0, and the brighter half of them from there on.
ColorMap alarm_colors();

/// Colours for a few words, the first at position 0, the last at 1: dark for what is right, and orange, light blue and
/// yellow, which people with any colour vision can tell apart (Okabe and Ito).
ColorMap word_colors(std::size_t words);

/// A direction's components as colour channels: -1 becomes 0, 1 becomes 255.
Rgb direction_color(double x, double y, double z);

/// The colour for no value: nearly black, darker than any map and than any direction.
inline constexpr Rgb no_value_color{20, 20, 20};

// For values outside a set range, and for infinite ones: purples, which no map has, each of another lightness.
inline constexpr Rgb below_color{96, 0, 110}, above_color{255, 70, 225};
inline constexpr Rgb minus_infinity_color{160, 20, 255}, infinity_color{255, 195, 255};

// Among the colours of danger: −∞ is the worst, so the brightest; ∞ is as safe as can be, a calm blue.
inline constexpr Rgb danger_minus_infinity_color{255, 255, 255}, danger_infinity_color{60, 130, 235};

}  // namespace glassbox
