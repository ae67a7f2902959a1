#pragma once
#include <cstddef>
#include <cstdint>

#include "engine/engine.hpp"

namespace glassbox::engine {

/// Prefetches a node or a block of triangles that will be visited soon. Without a branch, which would be mispredicted;
/// for a leaf of spheres it prefetches something useless. Always inlined: GCC drops calls of a function that only
/// prefetches.
[[gnu::always_inline]] inline void prefetch(const Engine& engine, std::uint32_t child) {
    constexpr std::size_t line = 64,
                          lines = 5;  // a block but for its last line, which only hits need; a node, and one more
    const bool is_leaf = Child::is_leaf(child);
    const auto first = is_leaf ? reinterpret_cast<std::uintptr_t>(engine.blocks().data())
                               : reinterpret_cast<std::uintptr_t>(engine.hierarchy().nodes.data());
    const std::uintptr_t at = first + Child::index(child) * (is_leaf ? sizeof(Block) : sizeof(Node));
    for (std::size_t i = 0; i < lines; ++i) __builtin_prefetch(reinterpret_cast<const void*>(at + i * line));
}

}  // namespace glassbox::engine
