#pragma once
#include <cmath>
#include <optional>

#include <chord.hpp>

#include "numerics/bounded_pair.hpp"
#include "numerics/double_double.hpp"
#include "render/search/surface_normal.hpp"

namespace glassbox {

/// A ray before a sphere far off, which is small as seen from there. The ray starts outside, so by all rules it meets
/// the sphere first half a chord before the chord's middle l (see chord.hpp), in l − √(h/a) D, h = r² − l², a = D², if
/// h > 0 and the middle lies ahead, m > 0. The point is as seen from the sphere's centre.
template <class Number>
struct FarHit {
    Number h, m;
    Vec3<Number> point;
};

template <class Number>
[[gnu::flatten]] FarHit<Number> far_hit(const Ray<double>& ray, const Sphere<double>& sphere) {
    using std::sqrt;
    const Number r(sphere.r);
    const auto [a, m, v, l] = chord(convert<Number>(ray), convert<Number>(sphere));
    const Number h = r * r - dot(l, l);
    return {h, m, l - sqrt(h / a) * convert<Number>(ray.D)};
}

/// Its coordinates as the nearest doubles, if for all of them these are sure; each is off by `error` at most.
inline std::optional<Vec3<double>> nearest_point(const Vec3<DoubleDouble>& point, const Vec3<double>& error) {
    const std::optional<double> x = nearest_double(point.x, error.x), y = nearest_double(point.y, error.y),
                                z = nearest_double(point.z, error.z);
    if (!x || !y || !z) return {};
    return Vec3<double>{*x, *y, *z};
}

/// By pairs of doubles and a bound in advance.
///
/// With V = |v|, the operations' errors as in DoubleDouble, and |m| ≤ V|D|:
/// - a is off relatively by 6.3u², m by 9.4u²V|D|, so m/a by 36u²V/|D|, its product with D by 3.1u²V more, and l by
///   6.3u²V more: less than 46u²V.
/// - h is off by what l is, times 2|l| and itself; l² by 8.1u² and two sums, and h by one more: 22u²r², as |l| < r.
/// - √(h/a) is off relatively by 0.55 times what h is, if that is 1/16 of it at most, and by 22u²; the product with D,
///   of size √h ≤ r, and the difference come to it: 33u²r with that.
/// 1.1 is for the bound's own rounding. Where numbers are of ordinary size, 2⁻¹⁰⁷⁰ is nothing beside it.
inline std::optional<Vec3<double>> far_point_by_bound(const Ray<double>& ray, const Sphere<double>& sphere) {
    constexpr double u2 = 0x1p-106;
    const double r = sphere.r, V = length(ray.P - sphere.C), size_D = length(ray.D);
    const auto [h, m, point] = far_hit<DoubleDouble>(ray, sphere);
    const double l_error = 46 * u2 * V, h_error = 2.1 * r * l_error + l_error * l_error + 22 * u2 * r * r;
    // A ray to a sphere so small runs nearly towards its centre.
    if (!(m.high > 0.5 * V * size_D) || !(h.high > 16 * h_error)) return {};
    const double error = 1.1 * (l_error + 0.55 * h_error / std::sqrt(h.high) + 33 * u2 * r);
    return nearest_point(point, {error, error, error});
}

/// By pairs with running bounds, which are much closer.
inline std::optional<Vec3<double>> far_point_by_running_bounds(const Ray<double>& ray, const Sphere<double>& sphere) {
    const auto [h, m, point] = far_hit<BoundedPair>(ray, sphere);
    if (!surely(h > BoundedPair(0)) || !surely(m > BoundedPair(0))) return {};
    const Bounded x = point.x.to_bounded(), y = point.y.to_bounded(), z = point.z.to_bounded();
    return nearest_point({DoubleDouble(x.value), DoubleDouble(y.value), DoubleDouble(z.value)},
                         {x.error, y.error, z.error});
}

/// Where a ray meets a far-off sphere, as seen from its centre: each coordinate of the true point rounded once, if
/// pairs of doubles are sure of that. It spares exact arithmetic, which takes a hundred times as long.
inline std::optional<Vec3<double>> far_point(const Ray<double>& ray, const Sphere<double>& sphere) {
    const auto is_ordinary = [](double size) { return size > 0x1p-100 && size < 0x1p100; };
    if (!is_far_off(ray, sphere) || !is_ordinary(greatest_coordinate(ray.P - sphere.C)) ||
        !is_ordinary(greatest_coordinate(ray.D)) || !is_ordinary(sphere.r))
        return {};
    if (const auto point = far_point_by_bound(ray, sphere)) return point;
    return far_point_by_running_bounds(ray, sphere);
}

}  // namespace glassbox
