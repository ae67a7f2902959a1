#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include <shading.hpp>

#include "scene/coefficients.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// How a scene is lit: the light's L and I, and how surfaces answer it.
struct Lighting {
    Vec3<double> L;
    double I;
    Shading<double> shading;
};

/// The lighting in numbers that the scalar can compute with, as they all are unless they are absurd. A factor beyond
/// its range is its largest number, and not infinite. An exponent leaves nothing of a highlight but its middle, and
/// makes nothing infinite of a cosine that was rounded to 1 and a few ulps. L, of which only the direction counts, has
/// a square.
template <class Real>
Lighting lighting(const Scene& scene) {
    using Limits = std::numeric_limits<Real>;
    const auto held = [](double factor) { return std::min(factor, static_cast<double>(Limits::max())); };
    Shading<double> s = scene.shading;
    for (const Coefficient<double>& coefficient : coefficients<double>)
        s.*coefficient.member = held(s.*coefficient.member);
    s.exponent = std::min(s.exponent, std::ldexp(1., Limits::digits + 3));

    constexpr int most = Limits::max_exponent / 2 - 4;
    const Vec3<double>& L = scene.light_vector;
    const int size = std::ilogb(std::max({std::abs(L.x), std::abs(L.y), std::abs(L.z)}));
    const double scale = std::ldexp(1., std::clamp(size, -most, most) - size);
    return {scale * L, held(scene.light_intensity), s};
}

}  // namespace glassbox
