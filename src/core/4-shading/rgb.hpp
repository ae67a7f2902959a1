#pragma once
#include <cmath>
#include <cstdint>

#include <vec3.hpp>

namespace glassbox {

/// A pixel's colour, a byte for each of red, green and blue.
struct Rgb {
    std::uint8_t red = 0, green = 0, blue = 0;

    friend constexpr bool operator==(const Rgb&, const Rgb&) = default;
};

/// Clamps a number to a byte's range and truncates it; NaN becomes 0.
template <class Real>
constexpr std::uint8_t truncated_byte(const Real& value) {
    if (!(value > Real(0))) return 0;
    return value < Real(255) ? static_cast<std::uint8_t>(value) : std::uint8_t{255};
}

/// Clamps a number to a byte's range and rounds it to the nearest integer; NaN becomes 0.
template <class Real>
constexpr std::uint8_t rounded_byte(const Real& value) {
    return truncated_byte(value + Real(0.5));
}

template <class Real>
constexpr Rgb rounded(const Vec3<Real>& color) {
    return {rounded_byte(color.x), rounded_byte(color.y), rounded_byte(color.z)};
}

template <class Real>
constexpr Rgb truncated(const Vec3<Real>& color) {
    return {truncated_byte(color.x), truncated_byte(color.y), truncated_byte(color.z)};
}

/// Adds channel by channel; clamps at 255.
constexpr Rgb operator+(const Rgb& a, const Rgb& b) {
    const auto add = [](int x, int y) { return static_cast<std::uint8_t>(x + y < 255 ? x + y : 255); };
    return {add(a.red, b.red), add(a.green, b.green), add(a.blue, b.blue)};
}

template <class Real>
constexpr Vec3<Real> to_vec3(const Rgb& color) {
    return {static_cast<Real>(color.red), static_cast<Real>(color.green), static_cast<Real>(color.blue)};
}

/// Light of that strength and colour. Here infinity times 0 is 0: a strength that overflowed lights no channel that is
/// 0. A strength that is NaN, because it came from such a product, lights no channel.
template <class Real>
Vec3<Real> tinted(const std::type_identity_t<Real>& strength, const Vec3<Real>& color) {
    using std::isfinite;
    if (isfinite(strength)) return strength * color;
    const auto channel = [&](const Real& c) { return c > Real(0) && strength > Real(0) ? strength : Real(0); };
    return {channel(color.x), channel(color.y), channel(color.z)};
}

}  // namespace glassbox
