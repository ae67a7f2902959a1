#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <ray.hpp>

#include "render/view.hpp"
#include "scene/scene.hpp"

namespace glassbox {

// Rays for benchmarks, the same on every machine. All their coordinates are floats, so that a tracer in single
// precision is asked exactly the same question as one in double.

/// The view of a scene with a pinhole, moved so little that every pixel's ray is made of floats.
FromEye view_in_floats(const Scene& scene);

/// A pixel's place in camera_rays.
std::uint32_t place_of_pixel(std::uint32_t x, std::uint32_t y);

/// The rays of all pixels of a square picture whose side is a power of two, in Morton order: neighbours in the list
/// are neighbours in the picture, as in a renderer that works tile by tile, and each 16 rays are 4 × 4 pixels.
std::vector<Ray<float>> camera_rays(const FromEye& view, int side);

/// Rays from points on the surfaces: where camera rays end, in their order.
struct RaysFromSurfaces {
    std::vector<Ray<float>> all_ways;       ///< in random directions, evenly over the sphere
    std::vector<Ray<float>> towards_light;  ///< all in the light's direction
};

/// `met` has the triangle of the scene's mesh that each camera ray meets first, or engine::no_surface.
RaysFromSurfaces rays_from_surfaces(const Scene& scene, std::span<const Ray<float>> rays,
                                    std::span<const std::uint32_t> met, const Vec3<float>& towards_light);

}  // namespace glassbox
