#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include <ray.hpp>

#include "engine/engine.hpp"

namespace glassbox::engine {

/// A ray as the boxes of a hierarchy are tested against it: in floats, so that no box is passed over that holds a point
/// of the true ray. After Ize, "Robust BVH Ray Traversal" (2013), for rays that are given in doubles.
///
/// The ray enters the slab between lo and hi of an axis at (lo − P)/D and leaves it at (hi − P)/D (D < 0: the other way
/// round), and meets the box if it enters the last of the three slabs no later than it leaves the first. Here:
/// - P is moved along the ray, by t₀, if it lies so far off that floats could not tell lo from P: to where the hierarchy
///   begins. What doubles lose of it is e_k = 2⁻⁵¹(|P_k| + |t₀D_k|).
/// - P ± e is rounded to floats so that the ray enters too early and leaves too late.
/// - What is left is the rounding of lo − P, of 1/D, and of their product, relatively by (1 + u)⁵, u = 2⁻²⁴. It keeps
///   signs, so that comparing an entry ≥ 0 with 1 + 2⁻²⁰ > ((1 + u)/(1 − u))⁵ times the exit is on the safe side.
/// - Along an axis where D is 0, or nearly, P stays where it is as long as the ray is in the hierarchy. Entry and exit
///   become ∓2¹²⁷ times its distance to a slab that is made a little wider, and so lie beyond all others if P is inside.
///
/// t counts in lengths of D divided by a power of two that makes its largest coordinate 1 to 2.
struct BoxRay {
    float near_from[3], far_from[3], inverse[3], exit_inverse[3];
    std::uint32_t near_side[3];  ///< Node::lo, or where D < 0 Node::hi

    double scale = 1, shift = 0;

    static constexpr float exit_factor = 1 + 0x1p-20f;

    /// No box beyond this entry holds a point of the ray before t.
    float t_max(double t) const {
        const double moved = t * scale - shift;
        if (!(moved < 0x1p100)) return std::numeric_limits<float>::infinity();
        return rounded_up(moved + std::abs(moved) * 0x1p-19 + 0x1p-100);
    }
};

/// 2 to the exponent of x, an ordinary number.
inline double power_of_two(double x) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0x7FF0'0000'0000'0000);
}

/// Nothing for a ray whose numbers are so large, so small or so different from each other that the bounds above fail,
/// or in a scene so small. `ray` must be valid.
inline std::optional<BoxRay> box_ray(const Ray<double>& ray, const Engine& engine) {
    std::optional<BoxRay> made;  // filled in place: a copy would wait for it to be written
    const double size = static_cast<double>(engine.around().reach());
    const double P[3] = {ray.P.x - engine.middle().x, ray.P.y - engine.middle().y, ray.P.z - engine.middle().z};
    const double D[3] = {ray.D.x, ray.D.y, ray.D.z};
    const double longest = std::max({std::abs(D[0]), std::abs(D[1]), std::abs(D[2])});
    const double farthest = std::max({std::abs(P[0]), std::abs(P[1]), std::abs(P[2])});
    if (!(size > 0x1p-50 && longest > 0x1p-100 && longest < 0x1p100 && farthest < 0x1p60)) return made;

    BoxRay& result = made.emplace();
    result.scale = power_of_two(longest);
    const double to_unit = std::bit_cast<double>(0x7FE0'0000'0000'0000 - std::bit_cast<std::uint64_t>(result.scale));  // its inverse
    if (farthest > 8 * size) {
        const Box& around = engine.around();
        const int main_axis = std::abs(D[0]) == longest ? 0 : std::abs(D[1]) == longest ? 1 : 2;
        const double begin = D[main_axis] > 0 ? around.lo[main_axis] : around.hi[main_axis];
        const double entry = (begin - P[main_axis]) / (D[main_axis] * to_unit) - (farthest + size) * 0x1p-48;
        result.shift = entry > 0 ? entry : 0;
    }
    for (int k = 0; k < 3; ++k) {
        double d = D[k] * to_unit;
        const double moved = P[k] + result.shift * d;
        double error = (std::abs(P[k]) + std::abs(result.shift * d)) * 0x1p-51;
        result.inverse[k] = 1 / static_cast<float>(d);
        if (!(std::abs(d) > 0x1p-60)) {
            // Along the main axis the ray goes on by t at least, and so has left the hierarchy at 16 times its size.
            error += 0x1p-22 * std::abs(moved) + 0x1p-56 * size;
            result.inverse[k] = 0x1p127f;
            d = 0;
        }
        result.near_side[k] = d < 0 ? Node::hi : Node::lo;
        result.exit_inverse[k] = result.inverse[k] * BoxRay::exit_factor;
        // Wider by 2⁻²³, so that it does not matter to which side floats round; and so much that no exit of a box that the
        // ray meets is as small as numbers that floats do not hold in full.
        const double wider = (error + std::abs(moved) * 0x1p-23) * (1 + 0x1p-20) + size * 0x1p-60;
        const double early = std::copysign(wider, d);  // so far ahead that a box is entered too early
        result.near_from[k] = static_cast<float>(moved + early);
        result.far_from[k] = static_cast<float>(moved - early);
    }
    return made;
}

}  // namespace glassbox::engine
