#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <ray.hpp>

#include "render/job.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// What each ray meets first, found by the plain certified loop over all surfaces but those far off that a look at a
/// sphere around them rules out: its number or engine::no_surface. Counts rays in job.done. Throws Cancelled.
std::vector<std::uint32_t> nearest_by_plain_loop(const Scene& scene, std::span<const Ray<double>> rays, const Job& job);

}  // namespace glassbox
