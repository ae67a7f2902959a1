#pragma once
#include <stop_token>

namespace glassbox {

/// Prints how fast the engine finds the nearest hits of primary rays, beside Embree on the same meshes. Throws
/// Cancelled.
void bench_against_embree(int runs, const std::stop_token& stop);

}  // namespace glassbox
