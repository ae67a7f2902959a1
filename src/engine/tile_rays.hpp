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

/// A tile's rays: their directions, about 1 long, and their starts. Only one of the two differs from ray to ray.
struct TileRays {
    bool pinhole;
    LinearVector<Vec3<double>> D, P;
    double most_D;      ///< as most_of tells
    double ray_error;   ///< how far D may be off in a pinhole's view, else P, summed over the axes
    double key_factor;  ///< RaysAtBlock's, of a block whose unit is 1

    double direction_error() const { return pinhole ? ray_error : 0; }
};

/// `middle` is the tile's middle ray.
inline TileRays tile_rays(const Grid& grid, const Ray<double>& middle) {
    const double scale = grid.direction_scale;
    const LinearVector<Vec3<double>> one_D{scale * middle.D, {}, {}}, one_P{middle.P, {}, {}};
    if (!grid.pinhole)
        return {false, one_D, {middle.P, grid.right, grid.up}, most_of(one_D), grid.ray_error, grid.key_of_t * scale};
    const LinearVector<Vec3<double>> D{scale * middle.D, scale * grid.right, scale * grid.up};
    return {true, D, one_P, most_of(D), scale * grid.ray_error, grid.key_of_t / scale};
}

/// A tile's rays as they are held against a block: in its units.
struct RaysAtBlock {
    LinearVector<Vec3<double>> p;      ///< the block's origin as seen from their starts
    LinearVector<Vec3<double>> p_x_D;  ///< p × D
    double most_p, most_p_x_D;
    double start_error;  ///< how far the starts may be off, summed over the axes
    /// A key is this times n/d, where n is the sum of the three side products, or in a parallel view −|A B C|, and d
    /// the other of the two.
    double key_factor;

    /// Whether floats neither overflow nor underflow in what the rays are held against: where the block is less than
    /// 2⁶⁰ of its units off, and its unit not beyond 2^±50 of the grid's distance, or a little more.
    bool are_within_floats() const { return most_p < 0x1p60 && key_factor < 0x1p50 && key_factor > 0x1p-60; }
};

/// Inline where it is called, as it is called for each block.
[[gnu::always_inline]] inline RaysAtBlock rays_at(const Block& block, const TileRays& rays) {
    const double unit = block.unit(), per_unit = block.per_unit;
    const Vec3<double> origin{block.origin[0], block.origin[1], block.origin[2]};
    const Vec3<double> p = per_unit * (origin - rays.P.value), D = rays.D.value;
    RaysAtBlock result;
    if (rays.pinhole) {
        result.p = {p, {}, {}};
        result.p_x_D = {cross(p, D), cross(p, rays.D.right), cross(p, rays.D.up)};
        result.most_p = sum_of_sizes(p);
        result.start_error = 0;
        result.key_factor = rays.key_factor * per_unit;
    } else {
        result.p = {p, -per_unit * rays.P.right, -per_unit * rays.P.up};
        result.p_x_D = {cross(p, D), cross(result.p.right, D), cross(result.p.up, D)};
        result.most_p = most_of(result.p);
        result.start_error = per_unit * rays.ray_error;
        result.key_factor = rays.key_factor * unit;
    }
    result.most_p_x_D = most_of(result.p_x_D);
    return result;
}

/// The key of what the rays meet in a triangle's plane, value + dj·right + di·up, but for `error`.
struct PreciseKey {
    double value, right, up, error;
    /// Whether the sign of |A B C|, or of D·N, is sure, and so which way the triangle faces; and floats hold all this.
    bool oriented;
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
inline PreciseKey precise_key(const TileRays& rays, const RaysAtBlock& at_block, const Block& block,
                              const Triangle<double>& triangle) {
    constexpr double u = 0x1p-53, larger = 1.34, tiny = 0x1p-110;
    const double per_unit = block.per_unit;
    const auto difference = [&](const Vec3<double>& a, const Vec3<double>& b) {
        const auto exact = [&](double x, double y) {
            return DoubleDouble(per_unit * (x - y), per_unit * lost_in_sum(x, -y, x - y));
        };
        return Vec3<DoubleDouble>{exact(a.x, b.x), exact(a.y, b.y), exact(a.z, b.z)};
    };
    const auto rounded = [](const Vec3<DoubleDouble>& v) { return Vec3<double>{v.x.high, v.y.high, v.z.high}; };

    const auto A = difference(triangle.A, rays.P.value), b = difference(triangle.A, triangle.C),
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
        n_error = error(rays.most_D) + 2 * g2 * rays.direction_error();
        d = V;
        d_error = V_error + 0x1p-1000;
    } else {
        n[0] = -V;
        n[1] = -dot(at_block.p.right, N);
        n[2] = -dot(at_block.p.up, N);
        n_error = V_error + error(at_block.most_p) + 2 * g2 * at_block.start_error;
        d = dot(rays.D.value, N);
        d_error = error(rays.most_D);
    }
    const double inverse = 1 / d, doubt = std::abs(inverse) * d_error, factor = at_block.key_factor * inverse;
    const double value = factor * n[0], right = factor * n[1], up = factor * n[2];
    const double most = std::abs(value) + half_tile * (std::abs(right) + std::abs(up));
    const double error_of_key = (std::abs(factor) * n_error + most * (doubt + 12 * 0x1p-24)) * larger + tiny;
    const bool fits_floats = most + error_of_key < 0x1p120;
    return {value, right, up, error_of_key, doubt < 0.25 && fits_floats, d < 0};
}

}  // namespace glassbox::engine
