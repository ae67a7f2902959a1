#pragma once
#include <cstdint>
#include <optional>

#include <viewing_plane.hpp>

#include "engine/engine.hpp"

namespace glassbox::engine {

/// Pixels on a side of a tile, whose rays are traced together.
inline constexpr int tile_side = 8;
inline constexpr int tile_size = tile_side * tile_side;

/// The rays of a picture, and how exactly they lie where they should.
///
/// All of them start in one point, or all run one way; the other of the two is L(j, i) = corner + j right + i up, but
/// for rounding. So within a tile about its middle (j₀, i₀) what decides about a triangle changes linearly in dj =
/// j − j₀ and di = i − i₀. With A, B seen from the rays' start, or from that of the middle, the side product D·(B × A)
/// is
///
///   (D₀ + dj right + di up)·(B × A)                      in a pinhole's view,
///   D·(B × A) + (dj right + di up)·((B − A) × D)         in a parallel one,
///
/// three numbers an edge, found once a tile in double, after which a ray costs two products. As dj and di are small,
/// single precision is enough for nearly all rays: see TileKernel in tile_kernel.cpp for the bounds.
struct Grid {
    // At the engine's scale, and for directions of ordinary length:
    bool pinhole = false;
    Vec3<double> eye;                ///< of a pinhole's view
    Vec3<double> direction;          ///< of a parallel one
    Vec3<double> corner, right, up;  ///< of a pinhole's plane as seen from its eye

    /// The powers of two by which directions, and what tells near from far, are multiplied: so that floats neither
    /// overflow nor underflow.
    double direction_scale = 1, key_scale = 1;
    /// They would where a triangle has corners as far off as this, or all within 2⁻¹⁵⁰ of it.
    double farthest = 0;
    /// |L − the ray's own number|, summed over the axes, for L and for the ray itself.
    double ray_error = 0;
    /// With m the largest coordinate of a triangle's vertices as seen from the rays: the errors of a side product are
    /// at most m(m side1 + side2), those of the determinant |A B C| at most m²(m volume1 + volume2), anywhere in a
    /// tile.
    double side1 = 0, side2 = 0, volume1 = 0, volume2 = 0;

    /// The engine's t, at its scale and along the directions above, is that of the view's rays times this.
    double t_scale = 1;
    /// What key is to that t: key = key_of_t/t in a pinhole's view, −key_of_t·t in a parallel one. A larger key is
    /// nearer.
    double key_of_t = 1;

    /// The powers of two that make of the size of the directions, and of the distance of what is seen near the engine's
    /// middle, numbers of about 1. In a pinhole's view, of directions and lengths times these, a key is 1/t.
    double per_direction() const { return key_of_t * per_distance(); }
    double per_distance() const { return 0x1p50 / farthest; }
};

/// Nothing where numbers are so large, small, or different that the bounds fail; the rays are then to be traced one by
/// one. Of pictures of width × height pixels, and a tile's side more.
std::optional<Grid> grid(const Parallel<double>& view, int width, int height, const Engine& engine);
/// `plane` is a pinhole's plane as seen from its eye: its points are the directions of the rays.
std::optional<Grid> grid(const Vec3<double>& eye, const ViewingPlane<double>& plane, int width, int height,
                         const Engine& engine);

inline constexpr std::uint32_t no_surface = 0xFFFFFFFF;  ///< none is met, for sure
inline constexpr std::uint32_t not_told = 0xFFFFFFFE;    ///< bounds do not tell: trace this ray by itself

/// A tile's rays are kept quarter by quarter, so that small triangles are met by few vectors of them.
inline constexpr int quarter_side = 4;
inline constexpr int quarter_size = quarter_side * quarter_side;

/// Where the ray is kept that is `x` columns and `y` rows from the tile's first.
constexpr int place_in_tile(int x, int y) {
    const int quarter = y / quarter_side * 2 + x / quarter_side;
    return quarter * quarter_size + y % quarter_side * quarter_side + x % quarter_side;
}

/// What a tile's rays meet first. Where it is a surface, its key is between the two.
struct alignas(64) Tile {
    std::uint32_t surface[tile_size];
    float key_low[tile_size], key_high[tile_size];
};

/// The engine's t of a key.
inline double t_of_key(const Grid& grid, float key) {
    return grid.pinhole ? grid.key_of_t / static_cast<double>(key) : -static_cast<double>(key) / grid.key_of_t;
}

/// The t of a key for the ray as the view has it.
inline double given_t_of_key(const Grid& grid, float key) { return t_of_key(grid, key) / grid.t_scale; }

/// The rays of the columns from `column` on, and of the rows from `row` on upwards.
void trace_tile(const Engine& engine, const Grid& grid, int column, int row, Tile& tile);

}  // namespace glassbox::engine
