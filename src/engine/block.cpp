#include "engine/block.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace glassbox::engine {

namespace {

/// So many blocks are made by one thread at a time.
constexpr std::size_t chunk = 1024;

/// Where a corner stands among those of its block, to which it is added if it is new. Compared bit by bit: −0 stays −0.
std::uint8_t place_of(const Vec3<double>& corner, std::size_t first, std::vector<Vec3<double>>& corners) {
    std::size_t at = first;
    while (at < corners.size() && std::memcmp(&corners[at], &corner, sizeof corner) != 0) ++at;
    if (at == corners.size()) corners.push_back(corner);
    return static_cast<std::uint8_t>(at - first);
}

/// A block without its floats, and its corners appended to `corners`.
Block exact_block(std::span<const std::uint32_t> surfaces, const NumberedTriangles& triangles,
                  std::vector<Vec3<double>>& corners) {
    Block block{};
    block.per_unit = 1;
    block.count = static_cast<std::uint8_t>(surfaces.size());
    block.first_corner = static_cast<std::uint32_t>(corners.size());
    for (std::uint32_t at = 0; at < fan_out; ++at) {
        block.surface[at] = surfaces[std::min<std::size_t>(at, surfaces.size() - 1)];
        const Triangle<double>& t = triangles[block.surface[at]];
        block.corner[0][at] = place_of(t.A, block.first_corner, corners);
        block.corner[1][at] = place_of(t.B, block.first_corner, corners);
        block.corner[2][at] = place_of(t.C, block.first_corner, corners);
    }
    return block;
}

/// The middle of the corners along an axis, and how far they reach from there.
struct Interval {
    double middle, reach;
};

Interval interval(std::span<const Vec3<double>> corners, double Vec3<double>::*k) {
    const auto [lo, hi] = std::ranges::minmax(corners, {}, k);
    const double middle = 0.5 * (lo.*k + hi.*k);
    return {middle, std::max(middle - lo.*k, hi.*k - middle)};
}

/// Gives a block, whose corners these are, its floats.
void set_floats(Block& block, std::span<const Vec3<double>> corners) {
    double reach = 0x1p-100;
    constexpr double Vec3<double>::*axes[3] = {&Vec3<double>::x, &Vec3<double>::y, &Vec3<double>::z};
    for (int k = 0; k < 3; ++k) {
        const Interval along = interval(corners, axes[k]);
        block.origin[k] = along.middle;
        reach = std::max(reach, along.reach);
    }
    const double per_unit = std::ldexp(1, -std::ilogb(reach) - 1);
    block.per_unit = per_unit;
    for (int k = 0; k < 3; ++k)
        for (std::uint32_t at = 0; at < fan_out; ++at) {
            const auto in_float = [&](int which) {
                const Vec3<double>& corner = corners[block.corner[which][at]];
                return static_cast<float>((corner.*axes[k] - block.origin[k]) * per_unit);
            };
            block.A[k][at] = in_float(0);
            block.B[k][at] = in_float(1);
            block.C[k][at] = in_float(2);
        }
}

}  // namespace

Blocks::Blocks(std::span<const Leaf> leaves, std::span<const std::uint32_t> surfaces,
               const NumberedTriangles& triangles)
    : blocks_(leaves.size()) {
    std::vector<std::vector<Vec3<double>>> corners((leaves.size() + chunk - 1) / chunk);  // of each chunk
    tbb::parallel_for(std::size_t{0}, corners.size(), [&](std::size_t part) {
        std::vector<Vec3<double>>& own = corners[part];
        const std::size_t first = part * chunk, last = std::min(first + chunk, leaves.size());
        own.reserve((last - first) * fan_out * 3 / 2);
        for (std::size_t i = first; i < last; ++i) {
            blocks_[i] = exact_block(surfaces.subspan(leaves[i].first, leaves[i].count), triangles, own);
            set_floats(blocks_[i], std::span(own).subspan(blocks_[i].first_corner));
        }
    });

    std::size_t all = 0;
    for (const auto& own : corners) all += own.size();
    corners_.reserve(all);
    for (std::size_t part = 0; part < corners.size(); ++part) {
        const auto before = static_cast<std::uint32_t>(corners_.size());
        for (std::size_t i = part * chunk; i < std::min((part + 1) * chunk, leaves.size()); ++i)
            blocks_[i].first_corner += before;
        corners_.insert(corners_.end(), corners[part].begin(), corners[part].end());
    }
}

void Blocks::add_unseen(std::span<const std::uint32_t> surfaces, const NumberedTriangles& triangles) {
    while (!surfaces.empty()) {
        const std::size_t some = std::min<std::size_t>(surfaces.size(), fan_out);
        blocks_.push_back(exact_block(surfaces.first(some), triangles, corners_));
        surfaces = surfaces.subspan(some);
    }
}

}  // namespace glassbox::engine
