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

/// The terms, by the model of `shading`.
template <class Real, class Probe>
Terms<Real> shade_by_model(const Vec3<Real>& n, const Vec3<Real>& r, const Vec3<Real>& color, const Light<Real>& light,
                           const Shading<Real>& shading, Probe& probe) {
    return shading.model == ShadingModel::levental_2014 ? shade_as_published(n, r, color, light, shading, probe)
                                                        : shade(n, r, color, light, shading, probe);
}

/// The pixel's colour, by the model.
template <class Real>
Rgb to_rgb(const Terms<Real>& terms, ShadingModel model) {
    return model == ShadingModel::levental_2014 ? to_rgb_as_published(terms) : to_rgb(terms);
}

}  // namespace glassbox
