#pragma once
#include <numbers>

#include <ray.hpp>

namespace glassbox {

/// The plane of the picture's pixels. Column j counts to the right, row i upwards; the bottom-left pixel is (0, 0).
template <class Real>
struct ViewingPlane {
    Vec3<Real> corner;  ///< the point of pixel (0, 0)
    Vec3<Real> right;   ///< from a pixel to its right neighbour
    Vec3<Real> up;      ///< from a pixel to the one above
};

/// The point of pixel column j and row i.
template <class Real>
Vec3<Real> point(const ViewingPlane<Real>& plane, const std::type_identity_t<Real>& j,
                 const std::type_identity_t<Real>& i) {
    return plane.corner + j * plane.right + i * plane.up;
}

/// Parallel rays that start on the plane (the paper's view).
template <class Real>
struct Parallel {
    ViewingPlane<Real> plane;
    Vec3<Real> direction;
};

/// Rays that start at the eye and pass through the plane.
template <class Real>
struct Pinhole {
    ViewingPlane<Real> plane;
    Vec3<Real> eye;
};

/// The ray of pixel column j and row i.
template <class Real>
Ray<Real> pixel_ray(const Parallel<Real>& view, const std::type_identity_t<Real>& j,
                    const std::type_identity_t<Real>& i) {
    return {point(view.plane, j, i), view.direction};
}

/// The ray of pixel column j and row i; it crosses the plane at t = 1.
template <class Real>
Ray<Real> pixel_ray(const Pinhole<Real>& view, const std::type_identity_t<Real>& j,
                    const std::type_identity_t<Real>& i) {
    return {view.eye, point(view.plane, j, i) - view.eye};
}

/// A pinhole view whose plane lies at distance 1 in front of the eye. `field_of_view` is vertical, in degrees, between
/// 0 and 180. Each ray passes through the centre of its pixel. `look_at - eye` and `up` must not be parallel.
template <class Real>
Pinhole<Real> looking(const Vec3<Real>& eye, const Vec3<Real>& look_at, const Vec3<Real>& up,
                      const std::type_identity_t<Real>& field_of_view, int width, int height) {
    using std::tan;
    const Vec3<Real> forward = unit(look_at - eye);
    const Vec3<Real> rightward = unit(cross(forward, up));
    const Vec3<Real> upward = cross(rightward, forward);
    const Real pixel = 2 * tan(field_of_view / 2 * (std::numbers::pi_v<Real> / 180)) / static_cast<Real>(height);
    const Vec3<Real> right = pixel * rightward;
    const Vec3<Real> above = pixel * upward;
    const Vec3<Real> corner =
        eye + forward - static_cast<Real>(width - 1) / 2 * right - static_cast<Real>(height - 1) / 2 * above;
    return {{corner, right, above}, eye};
}

}  // namespace glassbox
