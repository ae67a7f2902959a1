#pragma once
#include <light.hpp>
#include <reflection.hpp>
#include <rgb.hpp>
#include <shade_told.hpp>
#include <shading.hpp>

namespace glassbox {

/// The light that leaves a point towards the viewer, term by term, each as red, green, blue from 0 to 255.
template <class Real>
struct Terms {
    Vec3<Real> ambient, diffuse, specular;
};

/// n·h of Blinn's model: h = unit(l + r).
template <class Real, class Probe>
Real highlight_blinn(const Vec3<Real>& n, const Vec3<Real>& l, const Vec3<Real>& r, Probe& probe) {
    const Vec3<Real> h = halfway(l, r);
    const Real n_h = dot(n, h);
    probe(told::HalfVector{}, h);
    probe(told::NormalHalf{}, n_h);
    return n_h;
}

/// r·m of Phong's original model: how close the reflected light m comes to the viewer.
template <class Real, class Probe>
Real highlight_phong(const Vec3<Real>& n, const Vec3<Real>& l, const Vec3<Real>& r, Probe& probe) {
    const Vec3<Real> m = reflected(l, n);
    const Real r_m = dot(r, m);
    probe(told::Reflection{}, m, r_m);
    return r_m;
}

/// k_a I_a + I (k_d max(0, n·l) colour + k_s max(0, x)^e white), term by term (the paper's section 1.2.3); x is the
/// cosine of the highlight, `highlight()`, which comes after n·l and n·r are told. `r` is the unit vector towards the
/// viewer, `color` the surface's colour.
template <class Real, class Highlight, class Probe>
Terms<Real> terms(const Vec3<Real>& n, const Vec3<Real>& r, const Vec3<Real>& color, const Light<Real>& light,
                  const Shading<Real>& shading, const Highlight& highlight, Probe& probe) {
    const Real n_l = dot(n, light.l);
    probe(told::NormalLight{}, n_l);
    probe(told::NormalViewer{}, dot(n, r));
    const Real cosine = highlight();
    const Real diffuse_term = diffuse(light.intensity, shading.k_d, n_l);
    const Real specular_term = specular(light.intensity, shading.k_s, cosine, shading.exponent);
    probe(told::Ambient{}, shading.k_a);
    probe(told::DiffuseTerm{}, diffuse_term);
    probe(told::SpecularTerm{}, specular_term);
    return {tinted(shading.k_a, shading.ambient_color), tinted(diffuse_term, color),
            tinted(specular_term, shading.specular_color)};
}

/// The terms by Phong's or Blinn's model, at a point with that unit normal; it is turned towards the viewer first.
template <class Real, class Probe>
Terms<Real> shade(const Vec3<Real>& surface_normal, const Vec3<Real>& r, const Vec3<Real>& color,
                  const Light<Real>& light, const Shading<Real>& shading, Probe& probe) {
    const Vec3<Real> n = towards(r, surface_normal);
    const auto highlight = [&] {
        return shading.model == ShadingModel::phong ? highlight_phong(n, light.l, r, probe)
                                                    : highlight_blinn(n, light.l, r, probe);
    };
    return terms(n, r, color, light, shading, highlight, probe);
}

/// The pixel's colour, the sum of the terms.
template <class Real>
Rgb to_rgb(const Terms<Real>& terms) {
    return rounded(terms.ambient + terms.diffuse + terms.specular);
}

}  // namespace glassbox
