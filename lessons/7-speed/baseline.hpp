#pragma once
#include <cstdint>
#include <vector>

namespace glassbox {

/// The paper's picture, computed the way that the paper's program does it: the slow end of the speed lesson's scale.
/// Red, green and blue of each pixel, the top row first. The factors are the paper's k_a, k_d and k_s.
std::vector<unsigned char> render_as_published(int width, int height, double k_a, double k_d, double k_s);

/// How many rays that takes: one a pixel, the border's included. Each is tested against all six surfaces.
std::int64_t rays_as_published(int width, int height);

}  // namespace glassbox
