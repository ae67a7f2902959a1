#pragma once
#include <cmath>
#include <optional>

#include <ray.hpp>
#include <sphere.hpp>

#include "numerics/double_double.hpp"
#include "render/search/surface_normal.hpp"

namespace glassbox {

/// Where a ray meets a far-off sphere, as seen from its centre: each coordinate of the true point rounded once, if
/// pairs of doubles are sure of that. It spares exact arithmetic, which takes a hundred times as long.
///
/// The ray starts outside, so by all rules it meets the sphere first half a chord before the chord's middle l (see
/// chord.hpp), in l − √(h/a) D, h = r² − l², a = D², if h > 0 and the middle lies ahead: m > 0. With V = |v|, the
/// operations' errors as in DoubleDouble, and |m| ≤ V|D|:
/// - a is off relatively by 6.3u², m by 9.4u²V|D|, so m/a by 36u²V/|D|, its product with D by 3.1u²V more, and l by
///   6.3u²V more: less than 46u²V.
/// - h is off by what l is, times 2|l| and itself; l² by 8.1u² and two sums, and h by one more: 22u²r², as |l| < r.
/// - √(h/a) is off relatively by 0.55 times what h is, if that is 1/16 of it at most, and by 22u²; the product with D,
///   of size √h ≤ r, and the difference come to it: 33u²r with that.
/// 1.1 is for the bound's own rounding. Where numbers are of ordinary size, 2⁻¹⁰⁷⁰ is nothing beside it.
[[gnu::flatten]] inline std::optional<Vec3<double>> far_point(const Ray<double>& ray, const Sphere<double>& sphere) {
    constexpr double u2 = 0x1p-106;
    const auto is_ordinary = [](double size) { return size > 0x1p-100 && size < 0x1p100; };
    const Vec3<double>&P = ray.P, &D = ray.D, &C = sphere.C;
    const double r = sphere.r;
    const double V = length(P - C), size_D = length(D);
    if (!is_far_off(ray, sphere) || !is_ordinary(V) || !is_ordinary(size_D) || !is_ordinary(r)) return {};
    const Vec3<DoubleDouble> v{DoubleDouble::sum(P.x, -C.x), DoubleDouble::sum(P.y, -C.y),
                               DoubleDouble::sum(P.z, -C.z)};
    const DoubleDouble a =
        DoubleDouble::product(D.x, D.x) + DoubleDouble::product(D.y, D.y) + DoubleDouble::product(D.z, D.z);
    const DoubleDouble m = -(v.x * D.x + v.y * D.y + v.z * D.z), middle = m / a;
    const Vec3<DoubleDouble> l{v.x + middle * D.x, v.y + middle * D.y, v.z + middle * D.z};
    const DoubleDouble h = DoubleDouble::product(r, r) - (l.x * l.x + l.y * l.y + l.z * l.z);
    const double l_error = 46 * u2 * V, h_error = 2.1 * r * l_error + l_error * l_error + 22 * u2 * r * r;
    // A ray to a sphere so small runs nearly towards its centre.
    if (!(m.high > 0.5 * V * size_D) || !(h.high > 16 * h_error)) return {};
    const DoubleDouble half = sqrt(h / a);
    const double error = 1.1 * (l_error + 0.55 * h_error / std::sqrt(h.high) + 33 * u2 * r);
    const auto coordinate = [&](const DoubleDouble& from_centre, double of_D, const DoubleDouble& of_l) {
        const bool is_zero = from_centre.high == 0 && of_D == 0;
        return is_zero ? std::optional(0.0) : nearest_double(of_l - half * of_D, error);
    };
    const std::optional<double> x = coordinate(v.x, D.x, l.x), y = coordinate(v.y, D.y, l.y),
                                z = coordinate(v.z, D.z, l.z);
    if (!x || !y || !z) return {};
    return Vec3<double>{*x, *y, *z};
}

}  // namespace glassbox
