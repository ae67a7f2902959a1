#pragma once
#include <cmath>

#include <vec3.hpp>

namespace glassbox {

/// The half line f(t) = P + tD, t > 0. D may have any length but 0; t is measured in units of |D|.
template <class Real>
struct Ray {
    Vec3<Real> P, D;
};

/// f(t) = P + tD.
template <class Real>
Vec3<Real> at(const Ray<Real>& ray, const std::type_identity_t<Real>& t) {
    return ray.P + t * ray.D;
}

template <class Real>
bool is_finite(const Vec3<Real>& a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// Whether a ray can be traced: its numbers are finite and its direction is not zero.
template <class Real>
bool is_valid(const Ray<Real>& ray) {
    return is_finite(ray.P) && is_finite(ray.D) && ray.D != Vec3<Real>{};
}

/// The same ray in another scalar.
template <class To, class From>
Ray<To> convert(const Ray<From>& ray) {
    return {convert<To>(ray.P), convert<To>(ray.D)};
}

}  // namespace glassbox
