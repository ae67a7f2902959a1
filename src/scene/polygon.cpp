#include "scene/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glassbox {
namespace {

struct Point2 {
    double x, y;
    friend bool operator==(const Point2&, const Point2&) = default;
};

/// Twice the signed area of a triangle: positive where a, b, c run counter-clockwise.
double area(const Point2& a, const Point2& b, const Point2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether p is in the counter-clockwise triangle or on its edge. Its corners themselves do not count.
bool inside(const Point2& p, const Point2& a, const Point2& b, const Point2& c) {
    if (p == a || p == b || p == c) return false;
    return area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0;
}

double largest_component(const Vec3<double>& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// The polygon moved to the origin and scaled to size 1, lest products overflow, and laid flat: seen along the axis
/// that its normal is nearest to, from the side from which it runs counter-clockwise.
std::vector<Point2> flattened(std::span<const Vec3<double>> polygon) {
    std::vector<Vec3<double>> points;
    double size = 0;
    for (const auto& corner : polygon) {
        points.push_back(0.5 * corner - 0.5 * polygon.front());
        size = std::max(size, largest_component(points.back()));
    }
    if (size > 0)
        for (auto& point : points) point = point / size;

    // Newell's normal: the sum over all edges, so that no single corner decides.
    Vec3<double> normal;
    for (std::size_t i = 0; i < points.size(); ++i) normal = normal + cross(points[i], points[(i + 1) % points.size()]);

    const double largest = largest_component(normal);
    std::vector<Point2> flat;
    for (const auto& p : points) {
        if (std::abs(normal.z) == largest) flat.push_back(normal.z < 0 ? Point2{p.y, p.x} : Point2{p.x, p.y});
        else if (std::abs(normal.y) == largest) flat.push_back(normal.y < 0 ? Point2{p.x, p.z} : Point2{p.z, p.x});
        else flat.push_back(normal.x < 0 ? Point2{p.z, p.y} : Point2{p.y, p.z});
    }
    return flat;
}

/// The corner before `corner`, itself and the one after it, in a polygon whose corners are listed in `left`.
std::array<std::size_t, 3> around(const std::vector<std::size_t>& left, std::size_t corner) {
    const std::size_t n = left.size();
    return {left[(corner + n - 1) % n], left[corner], left[(corner + 1) % n]};
}

}  // namespace

std::vector<std::array<std::size_t, 3>> triangulate(std::span<const Vec3<double>> polygon) {
    const std::vector<Point2> flat = flattened(polygon);
    std::vector<std::size_t> left(polygon.size());
    std::iota(left.begin(), left.end(), std::size_t{0});

    const auto turns_left = [&](const std::array<std::size_t, 3>& abc) {
        return area(flat[abc[0]], flat[abc[1]], flat[abc[2]]) > 0;
    };
    // Only corners that do not turn left can lie in an ear, and cutting ears makes no new ones.
    std::vector<Point2> obstacles;
    for (std::size_t k = 0; k < left.size(); ++k)
        if (!turns_left(around(left, k))) obstacles.push_back(flat[k]);
    const auto is_ear = [&](const std::array<std::size_t, 3>& abc) {
        return turns_left(abc) && std::none_of(obstacles.begin(), obstacles.end(), [&](const Point2& p) {
                   return inside(p, flat[abc[0]], flat[abc[1]], flat[abc[2]]);
               });
    };

    std::vector<std::array<std::size_t, 3>> triangles;
    while (left.size() > 3) {
        // Corners 1, 2, …, n − 1, 0: from the second on, so that a convex polygon becomes a fan about its first.
        std::size_t ear = 1;
        for (std::size_t k = 1; k <= left.size(); ++k) {
            if (is_ear(around(left, k % left.size()))) {
                ear = k % left.size();
                break;
            }
        }
        triangles.push_back(around(left, ear));
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back({left[0], left[1], left[2]});
    return triangles;
}

}  // namespace glassbox
