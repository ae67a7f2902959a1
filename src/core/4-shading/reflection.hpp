#pragma once
#include <cmath>

#include <vec3.hpp>

namespace glassbox {

/// max(0, x); 0 for NaN.
template <class Real>
Real positive_part(const Real& x) {
    return x > Real(0) ? x : Real(0);
}

/// The unit normal n, flipped if it points away from the viewer, who is in direction r.
template <class Real>
Vec3<Real> towards(const Vec3<Real>& r, const Vec3<Real>& n) {
    return dot(n, r) < Real(0) ? -n : n;
}

/// I k_d max(0, n·l): Lambert's cosine law.
template <class Real>
Real diffuse(const Real& I, const Real& k_d, const Real& n_l) {
    return I * (k_d * positive_part(n_l));
}

/// The unit vector halfway between two others; the zero vector where they cancel.
template <class Real>
Vec3<Real> halfway(const Vec3<Real>& a, const Vec3<Real>& b) {
    const Vec3<Real> sum = a + b;
    return sum == Vec3<Real>{} ? sum : unit(sum);
}

/// The direction in which a mirror with the normal n reflects light from direction l: 2(n·l)n − l.
template <class Real>
Vec3<Real> reflected(const Vec3<Real>& l, const Vec3<Real>& n) {
    return 2 * dot(n, l) * n - l;
}

/// I k_s max(0, x)^e, x the cosine that says how close the viewer is to the highlight's middle: Blinn's n·h or Phong's
/// r·m.
template <class Real>
Real specular(const Real& I, const Real& k_s, const Real& cosine, const Real& e) {
    using std::pow;
    return I * (k_s * pow(positive_part(cosine), e));
}

}  // namespace glassbox
