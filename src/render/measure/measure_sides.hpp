#pragma once
#include <span>
#include <vector>

#include "render/job.hpp"
#include "render/measure/channel.hpp"
#include "render/measure/measurements.hpp"
#include "render/options.hpp"
#include "scene/scene.hpp"

namespace glassbox {

// What the plain loop, which tests every ray against every surface, would tell, without the loop.

/// Measures side products: each ray is tested against the triangles that can make a difference to what is asked.
/// Throws Cancelled.
std::vector<std::vector<Channel>> measured_by_sides(const Scene& scene, const Options& options, OfSides asked,
                                                    std::span<const Measurement* const> wanted, const Job& job);

/// How many surfaces each ray is tested against: all that the stage knows, or none if it is no ray. Throws Cancelled.
std::vector<std::vector<Channel>> counted_tests(const Scene& scene, const Options& options,
                                                std::span<const Measurement* const> wanted, const Job& job);

}  // namespace glassbox
