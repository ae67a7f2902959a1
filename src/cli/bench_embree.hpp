#pragma once
#include <optional>
#include <stop_token>

namespace glassbox {

/// Prints how fast the engine answers for camera rays, for rays from surfaces, and for those towards a light, beside
/// Embree on the same meshes; and how many answers are wrong, of `rays_to_check` of each, or of as many as take some
/// seconds. Returns whether all of the engine's are right. Throws Cancelled.
bool bench_against_embree(int runs, std::optional<int> rays_to_check, const std::stop_token& stop);

}  // namespace glassbox
