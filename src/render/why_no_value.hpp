#pragma once
#include <string>

#include "render/measurements.hpp"
#include "render/options.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// Why a measurement has no value at any pixel: "phong has no half vector".
std::string why_no_value(const Measurement& what, ShadingModel model, const Options& options);

}  // namespace glassbox
