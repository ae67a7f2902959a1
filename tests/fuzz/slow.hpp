#pragma once
#include <cstdint>
#include <string>

#include "drawn.hpp"

/// Random scenes that may take long.
namespace glassbox::fuzz {

/// Returns the scene of a seed: some kinds of surfaces, each a power of two in number, and what may make them slow: few
/// bits, copies, scales, offsets, surfaces far away or around everything. `kind` says what was drawn.
Drawn draw_slow(std::uint64_t seed);

/// An ordinary scene, with so many spheres and so many triangles about, spread over the picture.
Drawn draw_ordinary(std::size_t spheres, std::size_t triangles, int side);

}  // namespace glassbox::fuzz
