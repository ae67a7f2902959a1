#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include <ray.hpp>

#include "engine/engine.hpp"
#include "numerics/two_sum.hpp"

namespace glassbox::engine {

/// A ray as the engine sees it, whatever the scale of the scene and of the ray's own direction, and however far off it
/// starts.
///
/// It runs along d, the direction divided by a power of two that makes its largest coordinate 1 to 2; it starts at the
/// scene's scale (Engine::scale), and where it lies so far off that floats could not tell a box from its start, moved
/// along itself to where the hierarchy begins. Its own t counts in lengths of d from there.
///
/// The boxes are tested in floats, so that none is passed over that holds a point of the true ray. After Ize, "Robust
/// BVH Ray Traversal" (2013), for rays that are given in doubles. The ray enters the slab between lo and hi of an axis
/// at (lo − P)/d and leaves it at (hi − P)/d (d < 0: the other way round), and meets the box if it enters the last of
/// the three slabs no later than it leaves the first. Here:
/// - P is known but for `start_error`, and so rounded to floats that the ray enters too early and leaves too late.
/// - What is left is the rounding of lo − P, of 1/d, and of their product, relatively by (1 + u)⁵, u = 2⁻²⁴. It keeps
///   signs, so that comparing an entry ≥ 0 with 1 + 2⁻²⁰ > ((1 + u)/(1 − u))⁵ times the exit is on the safe side.
/// - Along an axis where d is 0, or nearly, P stays where it is as long as the ray is in the hierarchy. Entry and exit
///   become ∓2¹²⁷ times its distance to a slab that is made a little wider, and so lie beyond all others if P is
///   inside.
struct BoxRay {
    float near_from[3], far_from[3], inverse[3], exit_inverse[3];
    /// Where in a node the sides stand through which it enters and leaves, counted in floats from Node::side: along an
    /// axis where d < 0 it enters the upper ones.
    std::size_t near_side[3], far_side[3];

    double P[3], d[3];   ///< its start, off by `start_error` along each axis at most, and its direction
    double start_error;  ///< 0 where it was not moved
    double scale, per_scale, shift;
    bool as_given;  ///< neither moved nor at another scale, but for d, nor of a length far from 1

    static constexpr float exit_factor = 1 + 0x1p-20f;
    /// In multiples of the hierarchy's reach: rays that start farther off are moved.
    static constexpr double nearby = 8;

    Ray<double> ray() const { return {{P[0], P[1], P[2]}, {d[0], d[1], d[2]}}; }

    /// The ray's own t, between which and what is given a bound must allow for rounding.
    double own_t(double t) const { return t * scale - shift; }
    /// A t of the ray that was given, no larger or no smaller than the own one.
    double least_t(double own) const { return given_t(own, -1); }
    double most_t(double own) const { return given_t(own, 1); }

    /// No box beyond this entry holds a point of the ray before its own t.
    static float t_max_of(double own) {
        if (!(own < 0x1p100)) return std::numeric_limits<float>::infinity();
        // By 2⁻¹⁹, and by 2⁻²³ for the rounding: rounding upwards would take a branch that nobody can foresee.
        return static_cast<float>(own + std::abs(own) * 0x1.1p-19 + 0x1p-100);
    }
    /// The same for a t of the ray that was given.
    float t_max(double t) const { return t_max_of(own_t(t)); }

private:
    double given_t(double own, double side) const {
        const double sum = own + shift;
        return (sum + side * 0x1p-50 * (std::abs(own) + std::abs(shift))) * per_scale + side * 0x1p-1060;
    }
};

/// 2 to the exponent of x, an ordinary number.
inline double power_of_two(double x) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0x7FF0'0000'0000'0000);
}
/// Its inverse.
inline double inverse_power_of_two(double power) {
    return std::bit_cast<double>(0x7FE0'0000'0000'0000 - std::bit_cast<std::uint64_t>(power));
}

/// A number and the most that it is off.
struct Approximately {
    double value, error;
};

/// P − middle + td, found with twice the digits of a double, so that the first and the last may cancel: Knuth's
/// two-sum, and what a product lacks by one multiplication and addition without rounding between.
inline Approximately moved_along(double P, double middle, double t, double d) {
    const double from = P - middle, product = t * d, sum = from + product;
    const double rest = lost_in_sum(P, -middle, from) + std::fma(t, d, -product) + lost_in_sum(from, product, sum);
    return {sum + rest, (std::abs(from) + std::abs(product)) * 0x1p-98 + std::abs(sum + rest) * 0x1p-52};
}

/// Moves a ray's start, and what the hierarchy's boxes are tested with, to where the hierarchy begins, if the ray comes
/// from outside; false where floats could not say even then where it starts. For rays that start far off.
[[gnu::noinline]] inline bool move_near(BoxRay& result, const Engine& engine, double (&start)[3], double (&error)[3]) {
    const double size = engine.reach();
    const double middle[3] = {engine.middle().x, engine.middle().y, engine.middle().z};
    const double P[3] = {result.P[0], result.P[1], result.P[2]};
    const double(&d)[3] = result.d;
    const int main_axis = std::abs(d[0]) >= 1 ? 0 : std::abs(d[1]) >= 1 ? 1 : 2;
    const double begin = d[main_axis] > 0 ? engine.around().lo[main_axis] : engine.around().hi[main_axis];
    const auto farthest = [&] { return std::max({std::abs(start[0]), std::abs(start[1]), std::abs(start[2])}); };
    for (int times = 0; times < 2; ++times) {  // the second from nearby, with more digits
        const double entry = (begin - start[main_axis]) / d[main_axis] - (farthest() + size) * 0x1p-48;
        if (!(entry > 0)) break;
        result.shift = (result.shift + entry) * (1 - 0x1p-52);
        result.as_given = false;
        result.start_error = 0;
        for (int k = 0; k < 3; ++k) {
            const Approximately moved = moved_along(P[k], middle[k], result.shift, d[k]);
            start[k] = moved.value;
            error[k] = moved.error;
            result.P[k] = middle[k] + start[k];
            result.start_error = std::max(result.start_error, error[k] + std::abs(result.P[k]) * 0x1p-52);
        }
    }
    return farthest() < 0x1p100;
}

/// What a ray needs to know of an axis: see BoxRay. Its start relative to the middle is off by `error`, and its
/// direction is the given one over `power`, of which it is 2⁻¹²⁷ at least.
inline void set_axis(BoxRay& result, int k, double start, double error, double direction, double power, double size) {
    result.inverse[k] = static_cast<float>(power) * (1 / static_cast<float>(direction));
    result.exit_inverse[k] = result.inverse[k] * BoxRay::exit_factor;
    const std::size_t is_down = direction < 0;
    result.near_side[k] = Node::place_of_side(is_down, static_cast<std::size_t>(k));
    result.far_side[k] = Node::place_of_side(1 - is_down, static_cast<std::size_t>(k));
    // Wider by 2⁻²³, so that it does not matter to which side floats round; and so much that no exit of a box that the
    // ray meets is as small as numbers that floats do not hold in full.
    const double wider = (error + std::abs(start) * 0x1p-23) * (1 + 0x1p-20) + size * 0x1p-60;
    const double early = std::copysign(wider, direction);  // so far ahead that a box is entered too early
    result.near_from[k] = static_cast<float>(start + early);
    result.far_from[k] = static_cast<float>(start - early);
}

/// As set_up, for rays that are not ordinary: of another scale than the scene's, or along an axis, or from far off.
[[gnu::noinline]] inline bool set_up_unusual(BoxRay& result, const Ray<double>& ray, const Engine& engine) {
    const double size = engine.reach(), s = engine.scale();
    const Vec3<double>& middle = engine.middle();
    const auto& [x, y, z] = ray.D;
    const double longest = std::max({std::abs(x), std::abs(y), std::abs(z)});
    const double power = power_of_two(longest), to_unit = inverse_power_of_two(power), scale = s * power;
    // From now on relative to the middle.
    double start[3] = {s * ray.P.x - middle.x, s * ray.P.y - middle.y, s * ray.P.z - middle.z};
    const double farthest = std::max({std::abs(start[0]), std::abs(start[1]), std::abs(start[2])});
    if (!(size > 0x1p-50 && longest > 0x1p-1000 && longest < 0x1p1000 && scale > 0x1p-1000 && scale < 0x1p1000 &&
          farthest < 0x1p300))
        return false;

    const double P[3] = {s * ray.P.x, s * ray.P.y, s * ray.P.z}, d[3] = {x * to_unit, y * to_unit, z * to_unit};
    for (int k = 0; k < 3; ++k) {
        result.P[k] = P[k];
        result.d[k] = d[k];
    }
    result.scale = scale;
    result.per_scale = inverse_power_of_two(scale);
    result.shift = result.start_error = 0;
    result.as_given = s == 1 && longest > 0x1p-90 && longest < 0x1p90;
    double error[3] = {std::abs(start[0]) * 0x1p-52, std::abs(start[1]) * 0x1p-52, std::abs(start[2]) * 0x1p-52};
    if (farthest > BoxRay::nearby * size && !move_near(result, engine, start, error)) return false;
    for (int k = 0; k < 3; ++k) {
        double direction = d[k];
        if (!(std::abs(direction) > 0x1p-60)) {
            // Along the main axis the ray goes on by t at least, and so leaves the hierarchy before t is as large as
            // the start is far off, and the hierarchy.
            const double far = std::max({std::abs(start[0]), std::abs(start[1]), std::abs(start[2])}) + size;
            error[k] += 0x1p-22 * std::abs(start[k]) + 0x1p-56 * far;
            direction = 0x1p-127;
        }
        set_axis(result, k, start[k], error[k], direction, 1, size);
    }
    return true;
}

/// False for a ray whose numbers are so large, so small or so different from each other that the bounds above fail.
/// `ray` must be valid.
[[gnu::always_inline]] inline bool set_up(BoxRay& result, const Ray<double>& ray, const Engine& engine) {
    const double size = engine.reach();
    const Vec3<double>&middle = engine.middle(), &P = ray.P, &D = ray.D;
    const double x = std::abs(D.x), y = std::abs(D.y), z = std::abs(D.z);
    const double longest = std::max(std::max(x, y), z), shortest = std::min(std::min(x, y), z);
    const double start[3] = {P.x - middle.x, P.y - middle.y, P.z - middle.z};
    const double farthest = std::max(std::max(std::abs(start[0]), std::abs(start[1])), std::abs(start[2]));
    const bool is_ordinary = (longest < 0x1p60) & (shortest > longest * 0x1p-60) & (longest > 0x1p-60) &
                             (farthest < BoxRay::nearby * size) & (size > 0x1p-50) & (engine.scale() == 1);
    if (!is_ordinary) [[unlikely]]
        return set_up_unusual(result, ray, engine);
    const double power = power_of_two(longest), to_unit = inverse_power_of_two(power);
    const double from[3] = {P.x, P.y, P.z}, along[3] = {D.x, D.y, D.z};
    for (int k = 0; k < 3; ++k) {
        result.P[k] = from[k];
        result.d[k] = along[k] * to_unit;
        set_axis(result, k, start[k], std::abs(start[k]) * 0x1p-52, along[k], power, size);
    }
    result.scale = power;
    result.per_scale = to_unit;
    result.shift = result.start_error = 0;
    result.as_given = true;
    return true;
}

/// The same; nothing where that is false.
inline std::optional<BoxRay> box_ray(const Ray<double>& ray, const Engine& engine) {
    BoxRay result;
    if (!set_up(result, ray, engine)) return {};
    return result;
}

}  // namespace glassbox::engine
