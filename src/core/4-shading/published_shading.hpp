#pragma once
#include <shade.hpp>

namespace glassbox {

/// What the paper's program does, kept as history: it never turns the normal towards the viewer, and its half vector is
/// unit(L + r) with the light's L, which is not of length 1.
template <class Real, class Probe>
Terms<Real> shade_as_published(const Vec3<Real>& n, const Vec3<Real>& r, const Vec3<Real>& color,
                               const Light<Real>& light, const Shading<Real>& shading, Probe& probe) {
    return terms(
        n, r, color, light, shading, [&] { return highlight_blinn(n, light.L, r, probe); }, probe);
}

/// Each term is truncated to a byte before they are added.
template <class Real>
Rgb to_rgb_as_published(const Terms<Real>& terms) {
    return truncated(terms.ambient) + truncated(terms.diffuse) + truncated(terms.specular);
}

}  // namespace glassbox
