#pragma once
#include <cmath>
#include <numbers>
#include <variant>

#include "engine/ray_kernel.hpp"
#include "render/view.hpp"

namespace glassbox {

// Rays of neighbouring pixels are traced together because most of what one of them comes near, its neighbours do, too.
// Where surfaces look much smaller than a pixel, as in a coarse picture of a large mesh, each ray would be held against
// nearly all that the others meet: there they are faster one by one. A tile tells how many leaves it tested; where the
// one before tested few, the next is traced together, too, and otherwise one of its rays is asked first.

/// How large a pixel is at this t of its ray, times |D|, as seen along D.
inline double pixel_area(const View& view, const Vec3<double>& D, double t) {
    const auto of_plane = [&](const ViewingPlane<double>& plane) {
        return std::abs(dot(cross(plane.right, plane.up), D));
    };
    if (const auto* from_eye = std::get_if<FromEye>(&view)) return t * t * of_plane(from_eye->plane);
    return of_plane(std::get<Parallel<double>>(view).plane);
}

/// How large a surface looks along D, times |D|.
inline double seen_area(const Triangle<double>& triangle, const Vec3<double>& D) {
    return std::abs(dot(cross(triangle.B - triangle.A, triangle.C - triangle.A), D)) / 2;
}
inline double seen_area(const Sphere<double>& sphere, const Vec3<double>& D) {
    return std::numbers::pi * sphere.r * sphere.r * length(D);
}

/// Whether what the ray meets first covers so small a part of its pixel that its neighbours rarely meet the same.
inline bool meets_too_fine(const engine::Engine& engine, const View& view, const Ray<double>& ray) {
    constexpr std::size_t few = 500;  // of so few surfaces no tile tests too many
    constexpr double small = 0.2;     // 0.1 to 0.3 do as well, as measured with meshes of a million triangles
    if (engine.size() <= few || !is_valid(ray)) return false;
    engine::BoxRay boxes;
    const engine::Candidates found = engine::first_candidates(engine, ray, boxes);
    if (!found.is_whole || found.count == 0) return false;
    const auto& [surface, sure, low] = found.list[0];
    const double pixel = pixel_area(view, ray.D, boxes.least_t(low));
    return engine.with_surface(surface, [&](const auto& shape) { return seen_area(shape, ray.D) < small * pixel; });
}

}  // namespace glassbox
