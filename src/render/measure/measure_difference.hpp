#pragma once
#include <memory>
#include <span>
#include <vector>

#include "render/job.hpp"
#include "render/measure/channel.hpp"
#include "render/measure/minus.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// One number's difference, and what it is the difference of.
struct MeasuredDifference {
    std::shared_ptr<const Measurement> what;  ///< says how the difference is named, told, coloured and searched
    Channel channel;                          ///< the one minus the other; no value where either has none
    Channel one, other;
};

/// Measures by the setup, and by what `minus` makes of it, and subtracts; of a measurement with several components each
/// becomes a difference of its own. Where both are the same infinity they do not differ: 0. Counts each pixel twice.
/// Throws Cancelled.
std::vector<MeasuredDifference> measure_difference(const Scene& scene, const Setup& setup, const Minus& minus,
                                                   std::span<const Measurement* const> wanted, const Job& job = {});

}  // namespace glassbox
