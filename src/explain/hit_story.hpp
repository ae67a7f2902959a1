#pragma once
#include "engine/engine.hpp"
#include "explain/explain.hpp"
#include "explain/told_test.hpp"
#include "explain/traced_pixel.hpp"

namespace glassbox {

/// What was computed where the ray meets its nearest surface, and the colour that the recorded steps give.
struct ToldHit {
    story::FirstHit hit;
    Rgb color;
    std::optional<ToldTest> test;  ///< of that surface by the chosen rule, on the same tape; not with Detail::recorded
};

/// `pixel` must have a nearest surface.
ToldHit hit_story(const Scene& scene, const engine::Engine& surfaces, const Options& options, const TracedPixel& pixel,
                  Rgb own_color, Detail detail);

/// Stage 1: the ray's direction as a colour, by `ray_color`.
struct ToldRay {
    story::Vector color;
    Rgb rounded;
    std::vector<story::StoryStep> steps;
    std::vector<Call> calls;  ///< in which they were done
};
ToldRay ray_story(const TracedPixel& pixel, Scalar scalar, int column, int row, Detail detail);

}  // namespace glassbox
