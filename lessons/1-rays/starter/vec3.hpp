#pragma once
#include <cmath>
#include <type_traits>

#include <floating_point.hpp>
#include <not_written.hpp>

namespace glassbox {

/// Three numbers (x, y, z): a point, a direction or a colour.
template <class Real>
struct Vec3 {
    Real x{}, y{}, z{};

    friend constexpr bool operator==(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
};

template <class Real>
constexpr Vec3<Real> operator+(const Vec3<Real>& a, const Vec3<Real>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class Real>
constexpr Vec3<Real> operator-(const Vec3<Real>& a, const Vec3<Real>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class Real>
constexpr Vec3<Real> operator-(const Vec3<Real>& a) {
    return {-a.x, -a.y, -a.z};
}

template <class Real>
constexpr Vec3<Real> operator*(const std::type_identity_t<Real>& s, const Vec3<Real>& a) {
    return {s * a.x, s * a.y, s * a.z};
}

template <class Real>
constexpr Vec3<Real> operator/(const Vec3<Real>& a, const std::type_identity_t<Real>& s) {
    return {a.x / s, a.y / s, a.z / s};
}

/// a·b = |a||b| cos θ, θ the angle between a and b.
template <class Real>
constexpr Real dot(const Vec3<Real>& a, const Vec3<Real>& b) {
    return not_written<Real>("dot");
}

/// a × b, perpendicular to both, right-handed. Swapping a and b negates every component, bit for bit.
template <class Real>
constexpr Vec3<Real> cross(const Vec3<Real>& a, const Vec3<Real>& b) {
    return not_written<Vec3<Real>>("cross");
}

/// |a|, in the units of a.
template <class Real>
Real length(const Vec3<Real>& a) {
    using std::sqrt;
    return not_written<Real>("length");
}

/// a/|a|: the direction of a, with length 1. Not a number for the zero vector.
template <class Real>
Vec3<Real> unit(const Vec3<Real>& a) {
    return not_written<Vec3<Real>>("unit");
}

/// The same vector in another scalar.
template <class To, class From>
constexpr Vec3<To> convert(const Vec3<From>& a) {
    return {static_cast<To>(a.x), static_cast<To>(a.y), static_cast<To>(a.z)};
}

}  // namespace glassbox
