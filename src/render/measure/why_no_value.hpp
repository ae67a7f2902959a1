#pragma once
#include <cstdint>
#include <string>

#include "render/measure/measurements.hpp"
#include "render/options.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// Why a measurement has no value at a pixel. A later reason is nearer to a value: the last of all pixels' reasons
/// counts.
enum class WhyNoValue : std::uint8_t {
    has_one,
    stage,          ///< the stage does not compute it
    shading_model,  ///< the shading model does not use it
    triangle_rule,  ///< neither does the rule for triangles
    scalar,         ///< the scalar proves nothing
    engine,         ///< there is no engine, and so no boxes
    invalid_ray,    ///< the ray is not finite, or has no direction
    no_surface,     ///< none was tested
    not_in_boxes,   ///< the ray's numbers or the scene's are too large or too small for boxes
    no_sphere,      ///< none was tested
    no_triangle,
    no_hit,
    wrong_surface,
    not_a_number,  ///< it was computed, and is NaN
};

/// How a measurement was made at a pixel.
struct Circumstances {
    const Options& options;
    ShadingModel model;
    bool by_engine;  ///< a hierarchy of boxes chose the surfaces
    bool valid_ray;
};

/// Finds the reason in what the pixel's probe heard.
WhyNoValue why_no_value(const Measurement& what, const PixelNumbers& numbers, const Circumstances& how);

/// "phong has no half vector"; empty for has_one.
std::string reason_text(WhyNoValue why, const Measurement& what, const Options& options);

}  // namespace glassbox
