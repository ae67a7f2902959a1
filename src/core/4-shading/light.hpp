#pragma once
#include <vec3.hpp>

namespace glassbox {

/// A light so far away that only its direction counts.
template <class Real>
struct Light {
    Vec3<Real> L;    ///< as in the scene: from the world's origin towards the light, of any length but 0
    Real intensity;  ///< I, 1 for full
    Vec3<Real> l;    ///< unit(L)
};

template <class Real>
Light<Real> directional_light(const Vec3<Real>& L, const std::type_identity_t<Real>& intensity) {
    return {L, intensity, unit(L)};
}

}  // namespace glassbox
