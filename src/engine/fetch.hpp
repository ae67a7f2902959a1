#pragma once
#include <cstddef>
#include <cstdint>

#include "engine/engine.hpp"

namespace glassbox::engine {

/// Has the memory bring a node or a block that will be visited soon. Without a branch, as nobody can foresee which of
/// the two it is; of a leaf of spheres it brings nothing useful. Inline: GCC takes a function that only does this for
/// one that does nothing.
[[gnu::always_inline]] inline void fetch(const Engine& engine, std::uint32_t child) {
    constexpr std::size_t line = 64, lines = 5;  // of a block all but the line that names its surfaces and counts them
    const bool is_leaf = Child::is_leaf(child);
    const auto first = is_leaf ? reinterpret_cast<std::uintptr_t>(engine.blocks().data())
                               : reinterpret_cast<std::uintptr_t>(engine.hierarchy().nodes.data());
    const std::uintptr_t at = first + Child::index(child) * (is_leaf ? sizeof(Block) : sizeof(Node));
    for (std::size_t i = 0; i < lines; ++i) __builtin_prefetch(reinterpret_cast<const void*>(at + i * line));
}

}  // namespace glassbox::engine
