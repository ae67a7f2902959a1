#pragma once
#include <vec3.hpp>

namespace glassbox {

/// All points at distance r > 0 from the centre C.
template <class Real>
struct Sphere {
    Vec3<Real> C;
    Real r;
};

/// The same sphere in another scalar.
template <class To, class From>
constexpr Sphere<To> convert(const Sphere<From>& sphere) {
    return {convert<To>(sphere.C), static_cast<To>(sphere.r)};
}

/// The outward unit normal at a point X of the sphere: (X − C) / |X − C|.
template <class Real>
Vec3<Real> normal(const Sphere<Real>& sphere, const Vec3<Real>& X) {
    return unit(X - sphere.C);
}

}  // namespace glassbox
