#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include <box.hpp>

namespace glassbox::engine {

/// How many children a node has, and how many surfaces a leaf holds: as many as the widest vectors of today hold floats
/// of one AVX register, or doubles of one AVX-512 register.
inline constexpr int fan_out = 8;

/// No hierarchy is deeper.
inline constexpr int most_levels = 100;

/// What a node's child is, in 32 bits: another node, a leaf of triangles, a leaf of spheres, or nothing.
struct Child {
    static constexpr std::uint32_t nothing = 0xFFFFFFFF, leaf = 0x80000000, spheres = 0x40000000;

    static constexpr bool is_leaf(std::uint32_t code) { return (code & leaf) != 0; }
    static constexpr bool is_of_spheres(std::uint32_t code) { return (code & spheres) != 0; }
    /// Which node, or which leaf of its kind.
    static constexpr std::uint32_t index(std::uint32_t code) { return code & 0x3FFFFFFF; }
};

/// Eight children and their boxes, axis by axis, as vectors read them: where they begin, and where they end. It fills
/// whole pairs of cache lines, as processors fetch them.
struct alignas(256) Node {
    static constexpr std::uint32_t lo = 0, hi = 1;
    float side[2][3][fan_out];
    std::uint32_t child[fan_out];

    /// Where the lower or upper sides along an axis begin, counted in floats from `side`.
    static constexpr std::size_t place_of_side(std::size_t lo_or_hi, std::size_t axis) {
        return (lo_or_hi * 3 + axis) * fan_out;
    }
};

/// A box with a surface in it.
struct Boxed {
    Box box;
    std::uint32_t surface;
    bool is_sphere;
};

/// Surfaces of one kind: a part of Hierarchy::surfaces.
struct Leaf {
    std::uint32_t first, count;
};

/// A bounding volume hierarchy. Node 0 is its root; there is none where there are no surfaces. Every surface lies in
/// one leaf.
struct Hierarchy {
    std::vector<Node> nodes;
    std::vector<std::uint32_t> surfaces;  ///< leaf by leaf
    std::vector<Leaf> triangle_leaves, sphere_leaves;
};

/// Builds it by the surface area heuristic: a range of surfaces is cut where the areas of the two parts' boxes, times
/// how many surfaces they hold, are least, after sorting them into 16 bins along each axis (Wald 2007, "On fast
/// construction of SAH-based bounding volume hierarchies"). A node takes its eight children by cutting the part with
/// the largest box again and again. The same for the same surfaces, whatever the number of threads; 0: all cores.
Hierarchy build(std::vector<Boxed> surfaces, int threads = 0);

}  // namespace glassbox::engine
