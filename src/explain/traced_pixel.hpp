#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include <crossing.hpp>
#include <ray.hpp>
#include <rgb.hpp>

#include "render/job.hpp"
#include "render/options.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// The renderer's own answer for one pixel, with its own scalar and rules.
struct TracedPixel {
    Ray<double> ray;
    Rgb color;
    std::optional<Hit<double>> nearest;
    Vec3<double> normal;
    std::vector<Hit<long double>> met;               ///< all surfaces met, in the order of their numbers
    std::vector<std::size_t> needed_exact;           ///< those that error bounds could not decide
    std::size_t tested = 0;                          ///< surfaces, on the way to the nearest, as `measure` counts them
    std::optional<std::size_t> nodes, boxes_missed;  ///< the same of the engine's hierarchy, where that is used
};

TracedPixel traced_pixel(const Scene& scene, const Options& options, int x, int y, const Job& job);

}  // namespace glassbox
