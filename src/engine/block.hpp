#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <triangle.hpp>

#include "engine/hierarchy.hpp"
#include "numerics/power_of_two_below.hpp"

namespace glassbox::engine {

/// The triangles of a leaf. Their corners are here twice: as floats, coordinate by coordinate, as vectors read them,
/// which decide for nearly all rays; and as they were given, each once, for whoever must know.
///
/// A float counts in units of the block's own, from an origin of the block's own. So it is −1 to 1 whatever the scene's
/// size, and off by 2⁻²⁴ at most. Places that are left over repeat the last triangle.
struct alignas(128) Block {
    float A[3][fan_out], B[3][fan_out], C[3][fan_out];
    double origin[3];
    double per_unit;  ///< a power of two
    std::uint32_t surface[fan_out];
    std::uint32_t first_corner;       ///< where the block's corners begin in Blocks::corners
    std::uint8_t corner[3][fan_out];  ///< which of them A, B and C are
    std::uint8_t count;

    double unit() const { return inverse_power_of_two(per_unit); }
};

/// The triangles that some numbers of surfaces stand for.
struct NumberedTriangles {
    std::span<const Triangle<double>> triangles;
    std::size_t first;  ///< the number of the first

    const Triangle<double>& operator[](std::uint32_t surface) const { return triangles[surface - first]; }
};

/// Triangles in blocks of up to `fan_out`.
class Blocks {
public:
    Blocks() = default;
    /// A block for each leaf. Coordinates must be less than 2¹⁰⁰.
    Blocks(std::span<const Leaf> leaves, std::span<const std::uint32_t> surfaces, const NumberedTriangles& triangles);

    /// Appends blocks that no ray is held against: their floats are all 0. Of triangles of any size.
    void add_unseen(std::span<const std::uint32_t> surfaces, const NumberedTriangles& triangles);

    std::size_t size() const { return blocks_.size(); }
    const Block* data() const { return blocks_.data(); }
    const Block& operator[](std::size_t number) const { return blocks_[number]; }

    Triangle<double> triangle(std::size_t number, std::uint32_t at) const { return triangle(blocks_[number], at); }
    Triangle<double> triangle(const Block& block, std::uint32_t at) const {
        const Vec3<double>* const corners = corners_.data() + block.first_corner;
        return {corners[block.corner[0][at]], corners[block.corner[1][at]], corners[block.corner[2][at]]};
    }

    std::size_t bytes() const { return blocks_.capacity() * sizeof(Block) + corners_.capacity() * sizeof(corners_[0]); }

private:
    std::vector<Block> blocks_;
    std::vector<Vec3<double>> corners_;  ///< block by block, the equal ones of a block once
};

}  // namespace glassbox::engine
