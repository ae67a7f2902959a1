#pragma once
#include <published_shading.hpp>

namespace glassbox {

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
