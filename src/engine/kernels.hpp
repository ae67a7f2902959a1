#pragma once
#include <cstdint>

#include <ray.hpp>

#include "engine/box_ray.hpp"
#include "engine/engine.hpp"
#include "engine/function_ref.hpp"

// The inner loops, compiled once for each kind of vectors that processors have; the best for this one is chosen when
// the program starts.

namespace glassbox::engine {

/// What a ray's way through a hierarchy met.
struct TraversalCounts {
    std::uint64_t nodes = 0;         ///< whose boxes were tested
    std::uint64_t boxes_missed = 0;  ///< that no ray meets, or not near enough
};

/// Is told which leaf may hold a surface that the ray meets; answers with t_max from now on: BoxRay::t_max of what it
/// found, or what it was.
using VisitLeaf = FunctionRef<float(std::uint32_t leaf, float t_max)>;

/// Is told which box is looked into: the code of a node or of a leaf, as in Node::child; the root's first.
using OpenBox = FunctionRef<void(std::uint32_t code)>;

/// Visits the leaves of the boxes that the ray meets before t_max: near ones first, more or less.
TraversalCounts traverse(const Hierarchy& hierarchy, const BoxRay& ray, float t_max, VisitLeaf visit);
TraversalCounts traverse(const Hierarchy& hierarchy, const BoxRay& ray, float t_max, VisitLeaf visit, OpenBox open);

/// The triangles of a block that the ray, or its line behind the start, may meet, a bit each: all others it surely
/// misses.
std::uint32_t not_missed(const Block& block, const BoxRay& ray);

/// The name of the vectors that were chosen: "AVX3", say.
const char* vectors_used();

}  // namespace glassbox::engine
