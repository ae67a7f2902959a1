#pragma once
#include <cmath>
#include <optional>

#include <ray.hpp>

#include "engine/engine.hpp"

namespace glassbox::engine {

/// A ray as the boxes of a hierarchy are tested against it: in floats, so that no box is passed over that holds a point
/// of the true ray. After Ize, "Robust BVH Ray Traversal" (2013), for rays that are given in doubles.
///
/// The ray enters the slab between lo and hi of an axis at (lo − P)/D and leaves it at (hi − P)/D (D < 0: the other way
/// round), and meets the box if it enters the last of the three slabs no later than it leaves the first. Here:
/// - P is moved along the ray to where the hierarchy begins, by t₀, so that it is no farther off than floats can tell
///   lo from P; rounding it so is covered by e_k = 2⁻⁵¹(|P_k| + |t₀D_k|);
/// - P ± e is rounded to floats so that the ray enters too early and leaves too late;
/// - what is left is the rounding of lo − P, of 1/D, and of their product, relatively by (1 + u)³, u = 2⁻²⁴. It keeps
///   signs, so that comparing an entry ≥ 0 with 1 + 2⁻²⁰ > ((1 + u)/(1 − u))³ times the exit is on the safe side.
/// - D = 0 along an axis: entry and exit become ∓2⁶⁰ times the distance to a slab made wider by 2⁻²⁰ of the hierarchy's
///   size, and so lie beyond all others if the ray is between them.
///
/// t counts in lengths of D divided by a power of two that makes its largest coordinate 1 to 2.
struct BoxRay {
    float near_from[3], far_from[3], inverse[3];
    bool backwards[3];

    double scale = 1, shift = 0;

    static constexpr float exit_factor = 1 + 0x1p-20f;

    /// No box beyond this entry holds a point of the ray before t.
    float t_max(double t) const {
        const double moved = t * scale - shift;
        if (!(moved < 0x1p100)) return std::numeric_limits<float>::infinity();
        return rounded_up(moved + std::abs(moved) * 0x1p-19 + 0x1p-100);
    }
};

/// Nothing for a ray whose numbers are so large, so small or so different from each other that the bounds above fail,
/// or in a scene so small. `ray` must be valid.
inline std::optional<BoxRay> box_ray(const Ray<double>& ray, const Engine& engine) {
    const float size = engine.around().reach();
    const double P[3] = {ray.P.x - engine.middle().x, ray.P.y - engine.middle().y, ray.P.z - engine.middle().z};
    const double D[3] = {ray.D.x, ray.D.y, ray.D.z};
    int main_axis = 0;
    for (int k = 1; k < 3; ++k)
        if (std::abs(D[k]) > std::abs(D[main_axis])) main_axis = k;
    const double longest = std::abs(D[main_axis]);
    const double farthest = std::max({std::abs(P[0]), std::abs(P[1]), std::abs(P[2])});
    if (!(size > 0x1p-50f && longest > 0x1p-100 && longest < 0x1p100 && farthest < 0x1p60)) return {};
    const int exponent = std::ilogb(longest);

    BoxRay result;
    result.scale = std::ldexp(1, exponent);
    const double to_unit = std::ldexp(1, -exponent);
    const Box& around = engine.around();
    const double begin = D[main_axis] > 0 ? around.lo[main_axis] : around.hi[main_axis];
    const double entry = (begin - P[main_axis]) / (D[main_axis] * to_unit) - (farthest + size) * 0x1p-48;
    result.shift = entry > 0 ? entry : 0;
    for (int k = 0; k < 3; ++k) {
        const double d = D[k] * to_unit;
        const double moved = P[k] + result.shift * d;
        double error = (std::abs(P[k]) + std::abs(result.shift * d)) * 0x1p-51;
        result.backwards[k] = d < 0;
        if (d == 0) {
            error += 0x1p-20 * (size + std::abs(moved));
            result.inverse[k] = 0x1p60f;
        } else if (std::abs(d) < 0x1p-60) {
            return {};
        } else {
            result.inverse[k] = static_cast<float>(1 / d);
        }
        const float lo = rounded_down(moved - error), hi = rounded_up(moved + error);
        result.near_from[k] = d < 0 ? lo : hi;
        result.far_from[k] = d < 0 ? hi : lo;
    }
    return result;
}

}  // namespace glassbox::engine
