#include "render/measure/why_no_value.hpp"

#include <fmt/format.h>

#include <cmath>

#include "render/measure/pixel_numbers.hpp"
#include "render/option_names.hpp"

namespace glassbox {

namespace {

/// The first stage that has the source.
int first_stage(Source source) {
    switch (source) {
        case Source::ray:
        case Source::proof:
            return 1;
        case Source::hit:
        case Source::spheres:
        case Source::true_t:
        case Source::boxes:
            return 2;
        case Source::sides:
            return 3;
        case Source::light:
        case Source::half_vector:
            return 4;
    }
    return 1;
}

/// Why the search did not report this source.
WhyNoValue why_silent(Source source, const PixelNumbers& numbers, const Circumstances& how) {
    using enum WhyNoValue;
    switch (source) {
        case Source::half_vector:
            if (how.model == ShadingModel::phong) return shading_model;
            return numbers.surface ? not_a_number : no_hit;
        case Source::hit:
        case Source::light:
            return numbers.surface ? not_a_number : no_hit;
        case Source::true_t:
            return numbers.verdict > 0 ? wrong_surface : numbers.surface ? not_a_number : no_hit;
        case Source::spheres:
            return numbers.sphere_tested ? not_a_number : no_sphere;
        case Source::sides:
            if (std::holds_alternative<MoellerTrumbore>(how.options.triangle_rule)) return triangle_rule;
            return numbers.triangles.tested ? not_a_number : no_triangle;
        case Source::boxes:
            if (!how.by_engine) return engine;
            return numbers.tests > 0 ? not_in_boxes : no_surface;
        case Source::proof:
            return scalar;
        case Source::ray:
            return not_a_number;
    }
    return not_a_number;
}

/// Why the engine is not used.
std::string why_no_engine(const Options& options) {
    if (options.engine == EngineChoice::plain) return "the plain loop has no boxes";
    if (std::holds_alternative<Tolerance>(options.triangle_rule))
        return "boxes are the fast engine's, and tolerance hits triangles where they are not";
    return "boxes are the fast engine's, and that answers certified";
}

}  // namespace

WhyNoValue why_no_value(const Measurement& what, const PixelNumbers& numbers, const Circumstances& how) {
    if (!std::isnan(what.read(numbers).front())) return WhyNoValue::has_one;
    if (how.options.stage < first_stage(what.source)) return WhyNoValue::stage;
    const WhyNoValue why = why_silent(what.source, numbers, how);
    // A reason that does not depend on the ray is the better one.
    return !how.valid_ray && why > WhyNoValue::invalid_ray ? WhyNoValue::invalid_ray : why;
}

std::string reason_text(WhyNoValue why, const Measurement& what, const Options& options) {
    switch (why) {
        case WhyNoValue::has_one:
            return "";
        case WhyNoValue::stage:
            return fmt::format("from stage {}", first_stage(what.source));
        case WhyNoValue::shading_model:
            return "phong has no half vector";
        case WhyNoValue::triangle_rule:
            return "moeller-trumbore has no side products";
        case WhyNoValue::scalar:
            return fmt::format("{} proves nothing; certified and exact do", name_of(options.scalar));
        case WhyNoValue::engine:
            return why_no_engine(options);
        case WhyNoValue::invalid_ray:
            return "no ray has a direction and finite numbers";
        case WhyNoValue::no_surface:
            return "no surface was tested";
        case WhyNoValue::not_in_boxes:
            return "the numbers are too large or too small for boxes: every ray took the plain loop";
        case WhyNoValue::no_sphere:
            return "no sphere was tested";
        case WhyNoValue::no_triangle:
            return "no triangle was tested";
        case WhyNoValue::no_hit:
            return "no ray meets a surface";
        case WhyNoValue::wrong_surface:
            return "no ray meets the surface that it should";
        case WhyNoValue::not_a_number:
            return fmt::format("not a number: too large or too small for {}",
                               name_of(is_proven(options.scalar) ? Scalar::double_ : options.scalar));
    }
    return "";
}

}  // namespace glassbox
