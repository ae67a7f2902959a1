#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include <shading.hpp>

#include "scene/coefficients.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// A scene's lighting: the light's L and I, and how surfaces reflect it.
struct Lighting {
    Vec3<double> L;
    double I;
    Shading<double> shading;
};

/// The lighting in numbers that the scalar can compute with; ordinary numbers stay as they are. A factor beyond the
/// scalar's range becomes its largest number, not infinity. The exponent is limited: the highlight may shrink to its
/// middle, but a cosine rounded to 1 and a few ulps does not become infinite. L, whose direction alone counts, is
/// scaled so that its square does not overflow or underflow.
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
