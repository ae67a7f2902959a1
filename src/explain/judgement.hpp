#pragma once
#include "engine/engine.hpp"
#include "explain/story.hpp"
#include "explain/traced_pixel.hpp"
#include "render/job.hpp"

namespace glassbox {

/// Compares what was traced with the truth. The ray must be valid. Neither `turned` nor `least` is known yet.
story::Judgement judged(const std::shared_ptr<const engine::Engine>& surfaces, const Options& options,
                        const TracedPixel& pixel, const TrueHits& truth);

/// The surface about which the search was wrong: one that is shown and not there, or one that is there and not shown;
/// none if the verdict is right.
std::optional<std::size_t> judged_wrongly(const story::Judgement& judgement);

/// The least sure of the signs that decide what was traced, of all surfaces that are tested; as yet without a row. The
/// ray must be valid. Throws Cancelled if the job is asked to stop.
std::optional<story::LeastSure> least_sure(const std::shared_ptr<const engine::Engine>& surfaces,
                                           const Options& options, const TracedPixel& pixel, const Job& job);

/// Which number of its row's steps that sign is of, and which step lost its bits.
void find_step(story::LeastSure& least, const std::vector<story::Surface>& rows);

/// The numbers in a surface's test that rounding put on the other side of what they are compared with.
std::vector<std::string> turned(const story::Surface& surface);

}  // namespace glassbox
