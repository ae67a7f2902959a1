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

/// The scene's picture, its border painted over it. The same bytes whatever the number of threads. Throws Cancelled.
Image render(const Scene& scene, const Options& options, const Job& job = {});

/// A border one pixel wide.
void paint_border(Image& image, Rgb color);

/// What the formulas computed at each pixel: the channels of each measurement, in the order given. The border is not
/// painted over them. Throws Cancelled.
std::vector<std::vector<Channel>> measure(const Scene& scene, const Options& options,
                                          std::span<const Measurement* const> wanted, const Job& job = {});

}  // namespace glassbox
