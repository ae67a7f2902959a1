#include "output/oklab.hpp"

#include <cmath>
#include <numbers>

namespace glassbox {
namespace {

// sRGB's transfer curve (IEC 61966-2-1), between a channel's byte and its share of light.
double light(std::uint8_t byte) {
    const double v = byte / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

std::uint8_t byte_of(double light) {
    const double v = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
    return rounded_byte(255 * v);
}

}  // namespace

OkLab to_oklab(const Rgb& color) {
    const double r = light(color.red), g = light(color.green), b = light(color.blue);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Rgb to_rgb(const OkLab& color) {
    const auto cubed = [](double v) { return v * v * v; };
    const double l = cubed(color.lightness + 0.3963377774 * color.a + 0.2158037573 * color.b);
    const double m = cubed(color.lightness - 0.1055613458 * color.a - 0.0638541728 * color.b);
    const double s = cubed(color.lightness - 0.0894841775 * color.a - 1.2914855480 * color.b);
    return {byte_of(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            byte_of(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            byte_of(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

OkLab oklch(double lightness, double chroma, double hue) {
    const double angle = hue * std::numbers::pi / 180;
    return {lightness, chroma * std::cos(angle), chroma * std::sin(angle)};
}

double difference(const OkLab& p, const OkLab& q) {
    return std::hypot(p.lightness - q.lightness, p.a - q.a, p.b - q.b);
}

}  // namespace glassbox
