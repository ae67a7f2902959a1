#pragma once
#include <span>
#include <vector>

#include "render/image.hpp"
#include "render/job.hpp"
#include "render/measure/channel.hpp"
#include "render/measure/measurements.hpp"
#include "render/options.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// Renders the scene's picture, and paints its border over it. Gives the same bytes for any number of threads. Throws
/// Cancelled.
Image render(const Scene& scene, const Options& options, const Job& job = {});

/// Paints a border one pixel wide.
void paint_border(Image& image, Rgb color);

/// Measures what the formulas compute at each pixel: the channels of each measurement, in the order given, without the
/// border. Throws Cancelled.
std::vector<std::vector<Channel>> measure(const Scene& scene, const Options& options,
                                          std::span<const Measurement* const> wanted, const Job& job = {});

}  // namespace glassbox
