#pragma once
#include <cstdint>
#include <optional>

#include <viewing_plane.hpp>

#include "engine/engine.hpp"

namespace glassbox::engine {

/// Pixels on a side of a tile, whose rays are traced together.
inline constexpr int tile_side = 32;
inline constexpr int tile_size = tile_side * tile_side;

/// The rays of a picture, and how exactly they lie where they should.
///
/// All of them start in one point, or all run one way; the other of the two is L(j, i) = corner + j right + i up, but
/// for rounding. So within a tile about its middle (j₀, i₀) what decides about a triangle changes linearly in dj =
/// j − j₀ and di = i − i₀. With D the direction, A and B seen from some origin O near the triangle, and p that origin
/// as seen from the rays' start, the side product D·((p + B) × (p + A)) is
///
///   D·(B × A) + (B − A)·(p × D),
///
/// and p × D, or D itself as well, changes linearly: three numbers an edge, found once a tile, after which a ray costs
/// two products. What is large, p, is multiplied in double; as all else is small, single precision is enough for nearly
/// all rays: see tile_triangles.inl for the bounds.
struct Grid {
    // At the engine's scale, and for directions of ordinary length:
    bool pinhole = false;
    Vec3<double> eye;                ///< of a pinhole's view
    Vec3<double> direction;          ///< of a parallel one
    Vec3<double> corner, right, up;  ///< of a pinhole's plane as seen from its eye

    /// A power of two by which directions become about 1 long.
    double direction_scale = 1;
    /// About as far as the engine's surfaces are from the rays' start, a power of two: see also
    /// RaysAtBlock::are_within_floats.
    double distance = 1;
    /// |L − the ray's own number|, summed over the axes, for L and for the ray itself.
    double ray_error = 0;

    /// The engine's t, at its scale and along the directions above, is that of the view's rays times this.
    double t_scale = 1;
    /// What key is to that t: key = key_of_t/t in a pinhole's view, −key_of_t·t in a parallel one. A larger key is
    /// nearer.
    double key_of_t = 1;
};

/// Nothing where numbers are so large, small, or different that the bounds fail; the rays are then to be traced one by
/// one. Of pictures of width × height pixels, and a tile's side more.
std::optional<Grid> grid(const Parallel<double>& view, int width, int height, const Engine& engine);
/// `plane` is a pinhole's plane as seen from its eye: its points are the directions of the rays.
std::optional<Grid> grid(const Vec3<double>& eye, const ViewingPlane<double>& plane, int width, int height,
                         const Engine& engine);

inline constexpr std::uint32_t no_surface = 0xFFFFFFFF;  ///< none is met, for sure
inline constexpr std::uint32_t not_told = 0xFFFFFFFE;    ///< bounds do not tell: trace this ray by itself

/// A tile's rays are kept part by part, so that small triangles are met by few vectors of them.
inline constexpr int part_side = 4;
inline constexpr int part_size = part_side * part_side;
inline constexpr int parts_across = tile_side / part_side;
inline constexpr int parts = parts_across * parts_across;
static_assert(tile_side % part_side == 0 && parts <= 256);

/// Where the ray is kept that is `x` columns and `y` rows from the tile's first.
constexpr std::uint32_t place_in_tile(std::uint32_t x, std::uint32_t y) {
    constexpr std::uint32_t side = part_side;
    const std::uint32_t part = y / side * parts_across + x / side;
    return part * part_size + y % side * side + x % side;
}

/// What a tile's rays meet first. Where it is a surface, at about this t: the engine's, see Grid::t_scale.
struct alignas(64) Tile {
    std::uint32_t surface[tile_size];
    float t[tile_size];
    std::uint32_t leaves;  ///< how many of the hierarchy's leaves the rays were held against
};

/// Rays that come near so many leaves are not traced together any further: they are faster one by one.
inline constexpr std::uint32_t most_leaves = 2 * tile_size;

/// The rays of the columns from `column` on, and of the rows from `row` on upwards.
void trace_tile(const Engine& engine, const Grid& grid, int column, int row, Tile& tile);

}  // namespace glassbox::engine
