#include "scene/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <truth.hpp>

#include "numerics/exact.hpp"
#include "scene/ears.hpp"
#include "scene/mountains.hpp"
#include "scene/orientation.hpp"

namespace glassbox {
namespace {

using Triangles = std::vector<std::array<std::size_t, 3>>;

double largest_component(const Vec3<double>& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Twice the polygon's area, along its normal (Newell): a sum over all edges, so that no single corner decides.
template <class Real>
Vec3<Real> newell(std::span<const Vec3<double>> polygon) {
    const auto seen = [from = convert<Real>(polygon.front())](const Vec3<double>& corner) {
        return convert<Real>(corner) - from;
    };
    Vec3<Real> normal;
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
        normal = normal + cross(seen(polygon[k]), seen(polygon[k + 1]));
    return normal;
}

/// An axis, 0 to 2, and a direction on it.
struct Axis {
    int number;
    bool negative;
};

template <class Real>
Axis nearest_axis(const Vec3<Real>& n) {
    using std::abs;
    const Real x = abs(n.x), y = abs(n.y), z = abs(n.z), zero(0);
    if (surely(z >= x) && surely(z >= y)) return {2, surely(n.z < zero)};
    if (surely(y >= x)) return {1, surely(n.y < zero)};
    return {0, surely(n.x < zero)};
}

/// The axis along which the polygon is thinnest.
Axis thinnest_axis(std::span<const Vec3<double>> polygon) {
    Vec3<double> size;
    for (const auto& corner : polygon) {
        const auto [x, y, z] = corner - polygon.front();
        size = {std::max(size.x, std::abs(x)), std::max(size.y, std::abs(y)), std::max(size.z, std::abs(z))};
    }
    if (size.z <= size.x && size.z <= size.y) return {2, false};
    return {size.y <= size.x ? 1 : 0, false};
}

/// The axis nearest to the polygon's normal. Along it, a polygon with any area is not seen edge-on.
Axis axis_of(std::span<const Vec3<double>> polygon) {
    const auto n = newell<double>(polygon);
    double size = 0;
    for (const auto& corner : polygon) size = std::max(size, largest_component(corner - polygon.front()));
    // A component is a sum of 2n products of size² at most, each rounded n + 4 times at most.
    const auto corners = static_cast<double>(polygon.size());
    const double doubt = 2 * corners * (corners + 4) * 0x1p-52 * size * size + 0x1p-900;
    if (doubt < 0x1p900 && largest_component(n) > doubt) return nearest_axis(n);

    const auto exact = newell<Exact>(polygon);
    const bool has_area = exact.x.sign() != 0 || exact.y.sign() != 0 || exact.z.sign() != 0;
    return has_area ? nearest_axis(exact) : thinnest_axis(polygon);
}

/// Projects the polygon along that axis, as seen from the side on which it runs counter-clockwise. No number changes.
std::vector<Point2> flattened(std::span<const Vec3<double>> polygon) {
    const auto [axis, negative] = axis_of(polygon);
    std::vector<Point2> flat;
    flat.reserve(polygon.size());
    for (const auto& p : polygon) {
        if (axis == 2) flat.push_back({p.x, p.y});
        else if (axis == 1) flat.push_back({p.z, p.x});
        else flat.push_back({p.y, p.z});
        if (negative) std::swap(flat.back().x, flat.back().y);
    }
    return flat;
}

/// Whether the outline turns left at each corner and goes around once: then only one corner has both its neighbours on
/// its right.
bool is_convex(std::span<const Point2> outline) {
    const std::size_t n = outline.size();
    std::size_t leftmost = 0;
    for (std::size_t k = 0; k < n; ++k) {
        const Point2 &a = outline[k], &b = outline[(k + 1) % n], &c = outline[(k + 2) % n];
        if (orientation(a, b, c) <= 0) return false;
        if (b < a && b < c) ++leftmost;
    }
    return leftmost == 1;
}

Triangles fan(std::size_t corners) {
    Triangles triangles;
    for (std::size_t k = 1; k + 1 < corners; ++k) triangles.push_back({0, k, k + 1});
    return triangles;
}

}  // namespace

Triangles triangulate(std::span<const Vec3<double>> polygon) {
    if (polygon.size() == 3) return fan(3);
    const std::vector<Point2> outline = flattened(polygon);
    if (is_convex(outline)) return fan(outline.size());
    std::optional<Triangles> mountains = cut_into_mountains(outline);
    Triangles triangles = mountains ? *std::move(mountains) : cut_ears(outline);
    for (auto& abc : triangles) std::rotate(abc.begin(), std::min_element(abc.begin(), abc.end()), abc.end());
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

}  // namespace glassbox
