#include "viewer/model/space/coarser.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <unordered_set>

#include <ray.hpp>

namespace glassbox {

namespace {

using Corners = std::array<Vec3<double>, 3>;

Corners corners_of(const Triangle<double>& triangle) { return {triangle.A, triangle.B, triangle.C}; }

/// A cube around all corners, cut into cells.
struct Grid {
    Vec3<double> corner;
    double cell = 1;

    std::uint64_t cell_of(const Vec3<double>& p) const {
        const auto at = [&](double from, double to) {
            return static_cast<std::uint64_t>(std::clamp((to - from) / cell, 0.0, 1e6));
        };
        return at(corner.x, p.x) << 42 | at(corner.y, p.y) << 21 | at(corner.z, p.z);
    }
};

struct Bounds {
    Vec3<double> least;
    double size = 0;  ///< of the longest side
};

Bounds bounds(std::span<const Triangle<double>> triangles) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Vec3<double> least{infinite, infinite, infinite}, greatest{-infinite, -infinite, -infinite};
    for (const Triangle<double>& triangle : triangles)
        for (const Vec3<double>& p : corners_of(triangle)) {
            if (!is_finite(p)) continue;
            least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
            greatest = {std::max(greatest.x, p.x), std::max(greatest.y, p.y), std::max(greatest.z, p.z)};
        }
    const Vec3<double> size = greatest - least;
    return {least, std::max({size.x, size.y, size.z})};
}

/// The mean of the corners in a cell.
struct Mean {
    Vec3<double> sum{};
    double count = 0;
};

struct TripleHash {
    std::size_t operator()(const std::array<std::uint64_t, 3>& cells) const {
        std::uint64_t hash = 0;
        for (const std::uint64_t cell : cells) hash = (hash ^ cell) * 0x9E3779B97F4A7C15u;
        return hash;
    }
};

std::vector<CoarserTriangle> merged_by(const Grid& grid, std::span<const Triangle<double>> triangles) {
    std::unordered_map<std::uint64_t, Mean> means;
    std::unordered_set<std::array<std::uint64_t, 3>, TripleHash> known;
    std::vector<std::pair<std::array<std::uint64_t, 3>, std::size_t>> kept;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        std::array<std::uint64_t, 3> cells{};
        const Corners corners = corners_of(triangles[i]);
        if (!is_finite(corners[0]) || !is_finite(corners[1]) || !is_finite(corners[2])) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            cells[k] = grid.cell_of(corners[k]);
            Mean& mean = means[cells[k]];
            mean.sum = mean.sum + corners[k];
            ++mean.count;
        }
        if (cells[0] == cells[1] || cells[1] == cells[2] || cells[2] == cells[0]) continue;
        std::array<std::uint64_t, 3> in_order = cells;
        std::sort(in_order.begin(), in_order.end());
        if (known.insert(in_order).second) kept.emplace_back(cells, i);
    }
    const auto mean = [&](std::uint64_t cell) { return means[cell].sum / means[cell].count; };
    std::vector<CoarserTriangle> result;
    for (const auto& [cells, i] : kept) result.push_back({{mean(cells[0]), mean(cells[1]), mean(cells[2])}, i});
    return result;
}

}  // namespace

std::vector<CoarserTriangle> coarser(std::span<const Triangle<double>> triangles, std::size_t most) {
    const auto [corner, size] = bounds(triangles);
    if (!(size > 0) || !std::isfinite(size)) return {};
    // A surface as large as the cube has about two triangles for each cell that it crosses.
    double cells = std::sqrt(static_cast<double>(most) / 2);
    for (int tries = 0; tries < 8 && cells >= 1; ++tries) {
        std::vector<CoarserTriangle> result = merged_by({corner, size / cells}, triangles);
        if (result.size() <= most) return result;
        cells *= .95 * std::sqrt(static_cast<double>(most) / static_cast<double>(result.size()));
    }
    return {};
}

}  // namespace glassbox
