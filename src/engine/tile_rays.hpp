#pragma once
#include <algorithm>
#include <cmath>

#include <ray.hpp>
#include <triangle.hpp>

#include "engine/block.hpp"
#include "engine/tile.hpp"
#include "numerics/double_double.hpp"
#include "numerics/vector_size.hpp"

namespace glassbox::engine {

/// From a tile's middle to its outermost rays, in pixels to the right or upwards.
inline constexpr double half_tile = (tile_side - 1) * 0.5;

/// Three vectors that make one that is linear within the tile, value + dj·right + di·up.
template <class Vector>
struct LinearVector {
    Vector value, right, up;
};

/// A bound on the sum of the coordinates' sizes, anywhere in the tile.
inline double most_of(const LinearVector<Vec3<double>>& v) {
    return sum_of_sizes(v.value) + half_tile * (sum_of_sizes(v.right) + sum_of_sizes(v.up));
}

/// A tile's rays as they are held against a block: in its units, and directions about 1 long.
struct TileRays {
    bool pinhole;
    LinearVector<Vec3<double>> D;      ///< their directions
    LinearVector<Vec3<double>> p;      ///< the block's origin as seen from their starts
    LinearVector<Vec3<double>> p_x_D;  ///< p × D
    /// A key is this times n/d, where n is the sum of the three side products, or in a parallel view −|A B C|, and d
    /// the other of the two.
    double key_factor;
    /// How far the rays may be off, summed over the axes: their directions in a pinhole's view, else their starts.
    double direction_error, start_error;

    /// Whether floats neither overflow nor underflow in what the rays are held against: where the block is less than
    /// 2⁶⁰ of its units off, and its unit not beyond 2^±50 of the grid's distance, or a little more.
    bool are_within_floats() const { return most_of(p) < 0x1p60 && key_factor < 0x1p50 && key_factor > 0x1p-60; }
};

/// `middle` is the tile's middle ray.
inline TileRays tile_rays(const Grid& grid, const Ray<double>& middle, const Block& block) {
    const auto unit = static_cast<double>(block.unit), per_unit = static_cast<double>(block.per_unit);
    const Vec3<double> origin{block.origin[0], block.origin[1], block.origin[2]};
    const Vec3<double> p = per_unit * (origin - middle.P), D = grid.direction_scale * middle.D;
    if (grid.pinhole) {
        const Vec3<double> right = grid.direction_scale * grid.right, up = grid.direction_scale * grid.up;
        return {true,
                {D, right, up},
                {p, {}, {}},
                {cross(p, D), cross(p, right), cross(p, up)},
                grid.key_of_t / grid.direction_scale * per_unit,
                grid.direction_scale * grid.ray_error,
                0};
    }
    const Vec3<double> right = -per_unit * grid.right, up = -per_unit * grid.up;
    return {false,
            {D, {}, {}},
            {p, right, up},
            {cross(p, D), cross(right, D), cross(up, D)},
            grid.key_of_t * grid.direction_scale * unit,
            0,
            per_unit * grid.ray_error};
}

/// The key of what the rays meet in a triangle's plane, value + dj·right + di·up, but for `error`.
struct PreciseKey {
    double value, right, up, error;
    bool oriented;     ///< whether the sign of |A B C|, or of D·N, is sure, and so which way the triangle faces
    bool is_negative;  ///< that sign
};

/// As exactly as doubles have it, for triangles of which floats do not tell enough: those seen edge-on, or from nearly
/// their own plane. `triangle` as the block's corners are given.
///
/// With u = 2⁻⁵³, edges of at most g along each axis, and N the cross product of two of them, at most 2g² along each:
/// - |A B C| = A·N, A as seen from the rays' start, is found with pairs of doubles, and off by 64u²g²|A|, as
///   DoubleDouble has it: |A| the sum of its coordinates' sizes.
/// - N in doubles is off by 8ug², so v·N by 16ug²|v|, for any v of the rays.
/// - If the ray is off by ε they change by 2g²ε, ε summed over the axes.
/// n/d with errors E and M < |d|/4 is off by (E + |n/d| M)/(|d| − M) at most; floats round it 12 times.
inline PreciseKey precise_key(const TileRays& rays, const Block& block, const Triangle<double>& triangle,
                              const Vec3<double>& start) {
    constexpr double u = 0x1p-53, larger = 1.34, tiny = 0x1p-110;
    const auto per_unit = static_cast<double>(block.per_unit);
    const auto difference = [&](const Vec3<double>& a, const Vec3<double>& b) {
        const auto exact = [&](double x, double y) {
            return DoubleDouble(per_unit * (x - y), per_unit * lost_in_sum(x, -y, x - y));
        };
        return Vec3<DoubleDouble>{exact(a.x, b.x), exact(a.y, b.y), exact(a.z, b.z)};
    };
    const auto rounded = [](const Vec3<DoubleDouble>& v) { return Vec3<double>{v.x.high, v.y.high, v.z.high}; };

    const auto A = difference(triangle.A, start), b = difference(triangle.A, triangle.C),
               c = difference(triangle.B, triangle.A);
    const Vec3<DoubleDouble> exactly_N = cross(c, b);
    const Vec3<double> N = rounded(exactly_N);
    const double g = std::max(greatest_coordinate(rounded(b)), greatest_coordinate(rounded(c))),
                 g2 = g * g * (1 + 0x1p-40);
    const double V = dot(A, exactly_N).high, V_error = 64 * u * u * g2 * sum_of_sizes(rounded(A)) + u * std::abs(V);
    const auto error = [&](double of_v) { return 16 * u * g2 * of_v + 0x1p-1000; };

    double n[3], n_error, d, d_error;
    if (rays.pinhole) {
        n[0] = dot(rays.D.value, N);
        n[1] = dot(rays.D.right, N);
        n[2] = dot(rays.D.up, N);
        n_error = error(most_of(rays.D)) + 2 * g2 * rays.direction_error;
        d = V;
        d_error = V_error + 0x1p-1000;
    } else {
        n[0] = -V;
        n[1] = -dot(rays.p.right, N);
        n[2] = -dot(rays.p.up, N);
        n_error = V_error + error(most_of(rays.p)) + 2 * g2 * rays.start_error;
        d = dot(rays.D.value, N);
        d_error = error(most_of(rays.D));
    }
    const double inverse = 1 / d, doubt = std::abs(inverse) * d_error, factor = rays.key_factor * inverse;
    const double value = factor * n[0], right = factor * n[1], up = factor * n[2];
    const double most = std::abs(value) + half_tile * (std::abs(right) + std::abs(up));
    return {value,        right, up, (std::abs(factor) * n_error + most * (doubt + 12 * 0x1p-24)) * larger + tiny,
            doubt < 0.25, d < 0};
}

}  // namespace glassbox::engine
