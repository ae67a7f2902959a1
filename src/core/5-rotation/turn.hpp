#pragma once
#include <cmath>
#include <numbers>
#include <utility>

#include <viewing_plane.hpp>

namespace glassbox {

enum class Axis { x, y, z };

/// A turn of the viewing plane about an axis of the world, counter-clockwise as seen from the axis's tip, in degrees.
template <class Real>
struct Turn {
    Axis axis;
    Real degrees;

    constexpr bool operator==(const Turn&) const = default;
};

/// A rotation, given by the images of the three axes' unit vectors (the columns of its matrix).
template <class Real>
struct Rotation {
    Vec3<Real> x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
};

template <class Real>
Vec3<Real> operator*(const Rotation<Real>& R, const Vec3<Real>& v) {
    return v.x * R.x + v.y * R.y + v.z * R.z;
}

/// The rotation that applies S first, then R.
template <class Real>
Rotation<Real> operator*(const Rotation<Real>& R, const Rotation<Real>& S) {
    return {R * S.x, R * S.y, R * S.z};
}

/// (cos, sin) of an angle in degrees; exact at quarter turns, which radians cannot represent.
template <class Real>
std::pair<Real, Real> cos_sin(const Real& degrees) {
    using std::cos, std::sin, std::remquo;
    int quarter = 0;
    const Real rest = remquo(degrees, Real(90), &quarter) * (std::numbers::pi_v<Real> / 180);
    const Real c = cos(rest), s = sin(rest);
    switch (quarter & 3) {
        case 0:
            return {c, s};
        case 1:
            return {-s, c};
        case 2:
            return {-c, -s};
        default:
            return {s, -c};
    }
}

/// The rotation of one turn.
template <class Real>
Rotation<Real> rotation(const Turn<Real>& turn) {
    const auto [c, s] = cos_sin(turn.degrees);
    switch (turn.axis) {
        case Axis::x:
            return {{1, 0, 0}, {0, c, s}, {0, -s, c}};
        case Axis::y:
            return {{c, 0, -s}, {0, 1, 0}, {s, 0, c}};
        default:
            return {{c, s, 0}, {-s, c, 0}, {0, 0, 1}};
    }
}

/// The rotation of all turns in the order given, each about an axis of the world. Build it anew from all turns:
/// rotating the points again and again would accumulate the rounding of every step. `turns` is any range of Turn<Real>.
template <class Real, class Turns>
Rotation<Real> rotation(const Turns& turns) {
    Rotation<Real> R;
    for (const Turn<Real>& turn : turns) R = rotation(turn) * R;
    return R;
}

/// Rotates a point about the pivot.
template <class Real>
Vec3<Real> turned(const Vec3<Real>& point, const Rotation<Real>& R, const Vec3<Real>& pivot) {
    return pivot + R * (point - pivot);
}

template <class Real>
ViewingPlane<Real> turned(const ViewingPlane<Real>& plane, const Rotation<Real>& R, const Vec3<Real>& pivot) {
    return {turned(plane.corner, R, pivot), R * plane.right, R * plane.up};
}

template <class Real>
Parallel<Real> turned(const Parallel<Real>& view, const Rotation<Real>& R, const Vec3<Real>& pivot) {
    return {turned(view.plane, R, pivot), R * view.direction};
}

template <class Real>
Pinhole<Real> turned(const Pinhole<Real>& view, const Rotation<Real>& R, const Vec3<Real>& pivot) {
    return {turned(view.plane, R, pivot), turned(view.eye, R, pivot)};
}

}  // namespace glassbox
