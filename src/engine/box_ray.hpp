#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>

#include <ray.hpp>

#include "engine/engine.hpp"
#include "numerics/power_of_two_below.hpp"
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
/// at X = (lo − P)/d and leaves it at Y = (hi − P)/d (d < 0: the other way round), and meets the box if it enters the
/// last of the three slabs no later than it leaves the first. With i = 1/d and u = 2⁻²⁴:
/// - An entry is found as lo·i − P₁i, where P₁ lies ahead of P by w, so that the ray enters too early; an exit as
///   hi·j − P₂j, where j = (1 + 2⁻²⁰)i and P₂ lies behind P by w, so that it leaves too late.
/// - Rounded are i, twice, and j once more; P₁, P₁i, lo·i, and the sum. So (lo − P)i becomes (lo − P)i(1 + u)⁵ at most,
///   but for u(3|P| + |Xd|)i and a little, which come of P₁ and of lo = P + Xd; w ≥ 2⁻²²|P| = 4u|P| hides the first,
///   and the 2⁻⁵³|P| by which P itself is rounded, relative to the middle.
/// - So an entry is at most X(1 + u)⁵ or below 0, and an exit, for Y ≥ 0, above 0 and at least Y(1 + 2⁻²⁰)(1 − u)⁶. As
///   1 + 2⁻²⁰ = 1 + 16u is more than both together, the entry, or 0, comes no later than the exit if X, or 0, is by Y.
/// - w has 2⁻⁶⁰ of the hierarchy's reach besides: an exit that should not be below 0 is so large that what floats lose
///   below their normal numbers is nothing to it.
/// - Along an axis where d is nearly 0, no more than ε = 2⁻⁶⁰, it counts as ε, and w has 16ε times how far the ray goes
///   until it leaves the hierarchy, at most: it enters by 0, and leaves later than all of that, if it is in the slab.
/// - No product is too large for floats: 1/d is 1/ε at most, and start and boxes are no farther off than 2¹²⁰ε: an
///   ordinary ray's, as boxes reach to 2⁵⁶ (Engine) and it starts within 8 times that; for others ε is chosen larger
///   where they would be.
struct BoxRay {
    static constexpr std::size_t lanes = 4;  ///< x, y, z, and one that means nothing
    alignas(16) float inverse[lanes], near_offset[lanes], exit_inverse[lanes], far_offset[lanes];
    /// Where in a node the sides stand through which it enters and leaves, counted in floats from Node::side: along an
    /// axis where d < 0 it enters the upper ones.
    alignas(32) std::int64_t near_side[lanes], far_side[lanes];

    alignas(32) double P[lanes];  ///< its start, off by `start_error` along each axis at most
    alignas(32) double d[lanes];  ///< its direction
    double start_error;           ///< 0 where it was not moved
    double scale, per_scale, shift;
    bool as_given;  ///< neither moved nor at another scale, but for d, nor of a length far from 1

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
    const double(&d)[BoxRay::lanes] = result.d;
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

/// A number for each axis, and one more: a vector of the compiler's own, so that code for wide registers takes one
/// instruction.
using EachAxis = double __attribute__((vector_size(sizeof(double) * BoxRay::lanes)));
using EachAxisInBits = std::int64_t __attribute__((vector_size(sizeof(std::int64_t) * BoxRay::lanes)));
using EachAxisInFloats = float __attribute__((vector_size(sizeof(float) * BoxRay::lanes)));

/// Sets what the boxes are tested with: see BoxRay, also for w. `start` is relative to the middle; `direction` is
/// `power`, a power of two, times d, and nowhere 0.
[[gnu::always_inline]] inline void set_axes(BoxRay& result, const EachAxis& start, const EachAxis& w,
                                            const EachAxis& direction, double power) {
    const EachAxisInBits sign = (EachAxisInBits)direction & std::numeric_limits<std::int64_t>::min();
    const auto ahead = (EachAxis)((EachAxisInBits)w | sign);  // w ≥ 0, with the direction's sign
    const EachAxisInFloats one = {1, 1, 1, 1};
    const EachAxisInFloats i = static_cast<float>(power) * (one / __builtin_convertvector(direction, EachAxisInFloats));
    const EachAxisInFloats j = i * (1 + 0x1p-20f);
    const EachAxisInFloats near_offset = -__builtin_convertvector(start + ahead, EachAxisInFloats) * i;
    const EachAxisInFloats far_offset = -__builtin_convertvector(start - ahead, EachAxisInFloats) * j;
    const auto lo = [](std::size_t k) { return static_cast<std::int64_t>(Node::place_of_side(Node::lo, k)); };
    const EachAxisInBits lower = {lo(0), lo(1), lo(2), lo(3)};
    constexpr auto upper = static_cast<std::int64_t>(Node::place_of_side(Node::hi, 0));
    const EachAxisInBits if_down = (sign >> 63) & upper;
    const EachAxisInBits near_side = lower + if_down, far_side = lower + upper - if_down;
    std::memcpy(result.inverse, &i, sizeof i);
    std::memcpy(result.near_offset, &near_offset, sizeof near_offset);
    std::memcpy(result.exit_inverse, &j, sizeof j);
    std::memcpy(result.far_offset, &far_offset, sizeof far_offset);
    std::memcpy(result.near_side, &near_side, sizeof near_side);
    std::memcpy(result.far_side, &far_side, sizeof far_side);
}

/// As set_up, for rays that are not ordinary: of another scale than the scene's, or along an axis, or from far off.
[[gnu::noinline]] inline bool set_up_unusual(BoxRay& result, const Ray<double>& ray, const Engine& engine) {
    const double size = engine.reach(), s = engine.scale();
    const Vec3<double>& middle = engine.middle();
    const auto& [x, y, z] = ray.D;
    const double longest = std::max({std::abs(x), std::abs(y), std::abs(z)});
    const double power = power_of_two_below(longest), to_unit = inverse_power_of_two(power), scale = s * power;
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
    // Along the main axis the ray goes on by t at least, and so leaves the hierarchy before t is as large as the start
    // is far off, and the hierarchy.
    const double far = std::max({std::abs(start[0]), std::abs(start[1]), std::abs(start[2])}) + size;
    const double epsilon = std::max(0x1p-60, far * 0x1p-120);
    result.P[3] = result.d[3] = 0;
    EachAxis from{}, w{}, direction = {1, 1, 1, 1};
    for (int k = 0; k < 3; ++k) {
        const bool is_nearly_0 = !(std::abs(d[k]) > epsilon);
        from[k] = start[k];
        w[k] = error[k] * (1 + 0x1p-20) + std::abs(start[k]) * 0x1p-22 + size * 0x1p-60;
        if (is_nearly_0) w[k] += 16 * epsilon * far;
        direction[k] = is_nearly_0 ? epsilon : d[k];
    }
    set_axes(result, from, w, direction, 1);
    return true;
}

/// False for a ray whose numbers are so large, so small or so different from each other that the bounds above fail.
/// `ray` must be valid.
[[gnu::always_inline]] inline bool set_up(BoxRay& result, const Ray<double>& ray, const Engine& engine) {
    const double size = engine.reach();
    const Vec3<double>&middle = engine.middle(), &P = ray.P, &D = ray.D;
    const double x = std::abs(D.x), y = std::abs(D.y), z = std::abs(D.z);
    const double longest = std::max(std::max(x, y), z), shortest = std::min(std::min(x, y), z);
    const EachAxis start = {P.x - middle.x, P.y - middle.y, P.z - middle.z, 0};
    const auto distance = (EachAxis)((EachAxisInBits)start & std::numeric_limits<std::int64_t>::max());
    const double farthest = std::max(std::max(distance[0], distance[1]), distance[2]);
    const bool is_ordinary = (longest < 0x1p60) & (shortest > longest * 0x1p-60) & (longest > 0x1p-60) &
                             (farthest < BoxRay::nearby * size) & (size > 0x1p-50) & (engine.scale() == 1);
    if (!is_ordinary) [[unlikely]]
        return set_up_unusual(result, ray, engine);
    const double power = power_of_two_below(longest), to_unit = inverse_power_of_two(power);
    const EachAxis from = {P.x, P.y, P.z, 0}, along = {D.x, D.y, D.z, 1}, d = along * to_unit;
    std::memcpy(result.P, &from, sizeof from);
    std::memcpy(result.d, &d, sizeof d);
    set_axes(result, start, distance * 0x1p-22 + size * 0x1p-60, along, power);
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
