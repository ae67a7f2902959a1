#pragma once
#include <cstdint>

#include <ray.hpp>

#include "engine/box_ray.hpp"
#include "engine/engine.hpp"

// The inner loops, compiled once for each kind of vectors that processors have; the best for this one is chosen when
// the program starts.

namespace glassbox::engine {

/// What a walk through a hierarchy met.
struct WalkCounts {
    std::uint64_t nodes = 0;         ///< whose boxes were tested
    std::uint64_t boxes_missed = 0;  ///< that no ray meets, or not near enough
};

/// Is told which leaf may hold a surface that the ray meets; answers with BoxRay::until of what it found, or `until` as
/// it was.
using VisitLeaf = float (*)(void* state, std::uint32_t leaf, float until);

/// Visits the leaves of the boxes that the ray meets before `until`: near ones first, more or less.
void walk(const Hierarchy& hierarchy, const BoxRay& ray, float until, VisitLeaf visit, void* state, WalkCounts& counts);

/// Is told which box the walk looks into: the code of a node or of a leaf, as in Node::child.
using OpenBox = void (*)(void* state, std::uint32_t child);

/// The same walk, told box by box: the root's first.
void walk(const Hierarchy& hierarchy, const BoxRay& ray, float until, VisitLeaf visit, OpenBox open, void* state,
          WalkCounts& counts);

/// The triangles of a block that the ray may meet, a bit each: all others it surely misses.
std::uint32_t not_missed(const Block& block, const Ray<double>& ray);

/// The name of the vectors that were chosen: "AVX3", say.
const char* vectors_used();

}  // namespace glassbox::engine
