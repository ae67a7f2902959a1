#pragma once
#include <cmath>

#include <light.hpp>
#include <rgb.hpp>

namespace glassbox {

namespace told {
struct NormalLight {};   ///< n·l, the cosine of the angle between normal and light
struct NormalViewer {};  ///< n·r, r the unit vector towards the viewer
struct HalfVector {};    ///< h
struct NormalHalf {};    ///< n·h
struct Reflection {};    ///< (reflection, r·reflection) of Phong's original model
struct Ambient {};       ///< k_a
struct DiffuseTerm {};   ///< I k_d max(0, n·l)
struct SpecularTerm {};  ///< I k_s max(0, n·h)^e
}  // namespace told

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

/// The light that leaves a point towards the viewer, term by term, each as red, green, blue from 0 to 255.
template <class Real>
struct Terms {
    Vec3<Real> ambient, diffuse, specular;
};

/// max(0, x); 0 for NaN.
template <class Real>
Real positive_part(const Real& x) {
    return x > Real(0) ? x : Real(0);
}

/// The unit vector halfway between two others; the zero vector where they cancel.
template <class Real>
Vec3<Real> halfway(const Vec3<Real>& a, const Vec3<Real>& b) {
    const Vec3<Real> sum = a + b;
    return sum == Vec3<Real>{} ? sum : unit(sum);
}

/// The unit normal n, flipped if it points away from the viewer.
template <class Real>
Vec3<Real> towards(const Vec3<Real>& r, const Vec3<Real>& n) {
    return dot(n, r) < Real(0) ? -n : n;
}

/// n·h of Blinn's model: h = unit(l + r).
template <class Real, class Probe>
Real highlight_blinn(const Vec3<Real>& n, const Vec3<Real>& l, const Vec3<Real>& r, Probe& probe) {
    const Vec3<Real> h = halfway(l, r);
    const Real n_h = dot(n, h);
    probe(told::HalfVector{}, h);
    probe(told::NormalHalf{}, n_h);
    return n_h;
}

/// r·(2(n·l)n − l) of Phong's original model: how close the reflected light comes to the viewer.
template <class Real, class Probe>
Real highlight_phong(const Vec3<Real>& n, const Vec3<Real>& l, const Vec3<Real>& r, Probe& probe) {
    const Vec3<Real> reflection = 2 * dot(n, l) * n - l;
    const Real r_m = dot(r, reflection);
    probe(told::Reflection{}, reflection, r_m);
    return r_m;
}

/// k_a I_a + I (k_d max(0, n·l) colour + k_s max(0, n·h)^e white), term by term (the paper's section 1.2.3).
/// `surface_normal` is the unit normal n, `r` the unit vector towards the viewer, `color` the surface's colour.
///
/// The model levental_2014 does what the paper's program does: it never flips the normal, and its half vector is
/// unit(L + r) with the light's L, which is not of length 1.
template <class Real, class Probe>
Terms<Real> shade(const Vec3<Real>& surface_normal, const Vec3<Real>& r, const Vec3<Real>& color,
                  const Light<Real>& light, const Shading<Real>& shading, Probe& probe) {
    using std::pow;
    const bool as_published = shading.model == ShadingModel::levental_2014;
    const Vec3<Real> n = as_published ? surface_normal : towards(r, surface_normal);
    const Real I = light.intensity;
    const Real n_l = dot(n, light.l);
    probe(told::NormalLight{}, n_l);
    probe(told::NormalViewer{}, dot(n, r));
    const Real highlight = shading.model == ShadingModel::phong ? highlight_phong(n, light.l, r, probe)
                           : as_published                       ? highlight_blinn(n, light.L, r, probe)
                                                                : highlight_blinn(n, light.l, r, probe);
    const Real diffuse = I * (shading.k_d * positive_part(n_l));
    const Real specular = I * (shading.k_s * pow(positive_part(highlight), shading.exponent));
    probe(told::Ambient{}, shading.k_a);
    probe(told::DiffuseTerm{}, diffuse);
    probe(told::SpecularTerm{}, specular);
    return {tinted(shading.k_a, shading.ambient_color), tinted(diffuse, color),
            tinted(specular, shading.specular_color)};
}

/// The pixel's colour, the sum of the terms. levental_2014 truncates each term to a byte before it adds them.
template <class Real>
Rgb to_rgb(const Terms<Real>& terms, ShadingModel model) {
    const auto& [ambient, diffuse, specular] = terms;
    if (model == ShadingModel::levental_2014) return truncated(ambient) + truncated(diffuse) + truncated(specular);
    return rounded(ambient + diffuse + specular);
}

}  // namespace glassbox
