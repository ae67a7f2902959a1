#pragma once
#include <rgb.hpp>

namespace glassbox {

/// A colour in OKLab, where equal distances look about equally far apart (Björn Ottosson, "A perceptual color space for
/// image processing", 2020): lightness 0 to 1, `a` from green to red, `b` from blue to yellow; a = b = 0 is grey.
struct OkLab {
    double lightness = 0, a = 0, b = 0;
};

/// Converts an sRGB colour.
OkLab to_oklab(const Rgb& color);

/// The nearest sRGB colour, each channel clamped to 0 … 255.
Rgb to_rgb(const OkLab& color);

/// The colour of that lightness, chroma (distance from grey) and hue angle in degrees.
OkLab oklch(double lightness, double chroma, double hue);

/// How different two colours look: 0 for equal ones, about 0.02 for just distinguishable ones, 1 for black and white.
double difference(const OkLab& p, const OkLab& q);

}  // namespace glassbox
