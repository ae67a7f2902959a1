#pragma once
#include <vec3.hpp>

namespace glassbox {

enum class ShadingModel { phong, blinn_phong, levental_2014 };

/// How surfaces reflect light. The k are factors, usually 0 to 1; colours range from 0 to 255.
template <class Real>
struct Shading {
    ShadingModel model = ShadingModel::blinn_phong;
    Real k_a{}, k_d{}, k_s{};
    Real exponent{};
    Vec3<Real> ambient_color, specular_color;

    bool operator==(const Shading&) const = default;
};

}  // namespace glassbox
