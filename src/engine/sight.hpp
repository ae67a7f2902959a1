#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include <box.hpp>

#include "engine/engine.hpp"
#include "engine/tile.hpp"
#include "numerics/vector_size.hpp"

namespace glassbox::engine {

/// A number that is linear in x, a point relative to the engine's middle and within its near reach: between w·x + low
/// and w·x + high, whatever floats lose.
struct Bounds {
    float w[3], low, high;
    /// The sides of a node's boxes that make the corner where it is least, or most, counted in floats from Node::side.
    std::size_t least_corner[3], most_corner[3];
};

/// Where a point is, as a tile's rays see it. With D the middle ray's direction it is that ray's start and, t being
/// that of a ray through it that is dj and di pixels off,
///
///   t (D + dj right + di up)      in a pinhole's view,
///   t D + dj right + di up        in a parallel one.
///
/// So t is linear in x, and so are t dj and t di, or dj and di.
struct Sight {
    Bounds t, right, up;
    bool pinhole;
    float near_reach;
    bool some_beyond;  ///< of the engine's boxes lie not within that
    double off_by;     ///< by how many pixels rounding may move a ray, or a point beside it, at most
};

/// The start of a tile's middle ray relative to the engine's middle, and its direction.
struct MiddleRay {
    Vec3<double> P, D;
};

/// n·(x − start)/volume. In floats each of its terms is rounded at most six times, relatively by 2⁻²⁴; n is the cross
/// product of two vectors whose sizes' product is `size`, and off by 2⁻⁵⁰ of it; it may also be off by `more`.
inline Bounds bounds(const Vec3<double>& n, const Vec3<double>& start, double volume, double size, double reach,
                     double more) {
    const double x = n.x / volume, y = n.y / volume, z = n.z / volume, d = -(x * start.x + y * start.y + z * start.z);
    const double sum = std::abs(x) + std::abs(y) + std::abs(z);
    const double far = reach + sum_of_sizes(start);
    const double error = 0x1p-21 * (sum * reach + std::abs(d)) + 0x1p-48 * size / std::abs(volume) * far + more;
    // A quarter more for rounding to floats: outwards that would take a branch that nobody can foresee.
    const double wider = 1.25 * error + 0x1p-120;
    Bounds result{{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)},
                  static_cast<float>(d - wider),
                  static_cast<float>(d + wider),
                  {},
                  {}};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t rises = result.w[k] > 0;
        result.least_corner[k] = Node::place_of_side(1 - rises, k);
        result.most_corner[k] = Node::place_of_side(rises, k);
    }
    return result;
}

/// By how many pixels rounding may move a ray: in most views much less than the first of them, which is nothing beside
/// a tile; and never more than the other.
inline constexpr double usually_off_by = 0.01, most_off_by = 0.5;

/// Nothing if rounding might move them more: the tile is then not to be traced as one.
inline std::optional<Sight> sight(const Engine& engine, const Grid& grid, const MiddleRay& middle) {
    const auto size = [](const Vec3<double>& v) { return sum_of_sizes(v); };
    const Vec3<double> R = grid.right, U = grid.up, D = middle.D, n = cross(R, U);
    const double sizes = size(R) * size(U) * size(D), volume = dot(D, n);
    // Off by 2⁻⁴⁸ of `sizes` at most: relatively by 2⁻³⁰, which moves nothing in the tile by more than 2⁻²⁶ pixels.
    if (!(std::abs(volume) > 0x1p-18 * sizes)) return {};
    // A ray that is off by ε is seen to be off by ε·(U × D)/volume and so on; in a pinhole's view t is then off
    // relatively by ε·n/volume, and so are dj and di, which are less than half a tile.
    const double by_ray = grid.ray_error / std::abs(volume);
    const double t_off = by_ray * size(n);
    const double moved = by_ray * (size(U) + size(R)) * size(D) + (grid.pinhole ? tile_side / 2 * t_off : 0);
    if (!(moved < most_off_by / 2)) return {};
    if (grid.pinhole && !(t_off < 0x1p-22)) return {};
    const double reach = static_cast<double>(engine.near_reach());
    // Floats must not overflow: an infinity less another would be no number.
    const double most = std::max({size(R) * size(U), size(U) * size(D), size(D) * size(R)});
    if (!(most * (reach + size(middle.P)) < 0x1p100 * std::abs(volume))) return {};
    return Sight{bounds(n, middle.P, volume, size(R) * size(U), reach, grid.pinhole ? 0 : t_off),
                 bounds(cross(U, D), middle.P, volume, size(U) * size(D), reach, 0),
                 bounds(cross(D, R), middle.P, volume, size(D) * size(R), reach, 0),
                 grid.pinhole,
                 engine.near_reach(),
                 engine.around().reach() > engine.near_reach(),
                 std::max(2 * moved, usually_off_by)};
}

/// What lies beyond this t lies behind something that is met at t: `bounds` and `sight` allow for 2⁻²², and a rounding
/// to floats for 2⁻²⁴.
inline float beyond(double t) { return static_cast<float>(t + std::abs(t) * 0x1p-20); }

}  // namespace glassbox::engine
