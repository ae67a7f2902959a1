#pragma once
#include <memory>

#include "engine/engine.hpp"
#include "explain/recorded_pixel.hpp"
#include "explain/story.hpp"

namespace glassbox {

/// The story of a pixel that another program recorded, with a learner's formulas: its tapes are replayed as ours are,
/// and what each test says is compared with the truth. It has no judgement, and of each test only the chosen rule's.
/// `options` are those that it was recorded by, but for the scalar, which is double.
Story retold(const Scene& scene, const std::shared_ptr<const engine::Engine>& surfaces, Options options, int x, int y,
             const RecordedPixel& recorded);

}  // namespace glassbox
