#pragma once
#include <optional>
#include <stop_token>
#include <vector>

#include "bench/cliffs/cliff.hpp"

namespace glassbox {

/// A cliff's times, and what came of checking its answers.
struct CliffTimes {
    std::size_t rays = 0;                    ///< that were traced, fewer where they take long
    std::vector<double> ordinary, this_one;  ///< nanoseconds a ray, run by run
    std::size_t checked = 0, wrong = 0;      ///< rays compared with the plain certified loop, and how many differ
};

/// Times a cliff beside its ordinary scene, in turn, on one thread; once only where that takes seconds. Checks
/// `rays_to_check` answers by the plain loop, or as many as it can do in about a second. Throws Cancelled.
CliffTimes time_cliff(const Cliff& cliff, int runs, std::optional<int> rays_to_check, const std::stop_token& stop);

}  // namespace glassbox
