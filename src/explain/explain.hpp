#pragma once
#include "explain/story.hpp"
#include "render/job.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// How much of a pixel's story to tell.
enum class Detail {
    recorded,  ///< what was computed at the hit; neither bounds nor true values, and no other surfaces
    judged,    ///< all but the least sure sign, which takes a plain scalar a test of each surface of the scene
    whole,
};

/// The story of the pixel (x, y), 0 ≤ x < width and 0 ≤ y < height, as `render` computes it. Fast for large scenes,
/// too, if the job provides their engine.
Story explain(const Scene& scene, const Options& options, int x, int y, Detail detail = Detail::whole, Job job = {});

}  // namespace glassbox
