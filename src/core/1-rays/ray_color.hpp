#pragma once
#include <cmath>

#include <ray.hpp>

namespace glassbox {

/// Shows a ray as red, green and blue from 0 to 255. Its direction gives the colour (x, y, z from -1 to 1 become red,
/// green, blue from dark to full); a chessboard with squares of 50 pixels shows the viewing plane.
template <class Real>
Vec3<Real> ray_color(const Ray<Real>& ray, int j, int i) {
    const Vec3<Real> D = unit(ray.D);
    const Real shade = (j / 50 + i / 50) % 2 == 0 ? Real(255) : Real(204);
    return shade / 2 * (D + Vec3<Real>{1, 1, 1});
}

}  // namespace glassbox
