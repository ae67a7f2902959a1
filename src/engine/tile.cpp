#include "engine/tile.hpp"

#include <cmath>

#include "numerics/vector_size.hpp"

namespace glassbox::engine {

namespace {

constexpr double u = 0x1p-53;

Vec3<double> sizes(const Vec3<double>& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

/// The sizes of what L(j, i) is the sum of, anywhere in the picture and a tile around it.
Vec3<double> plane_sizes(const ViewingPlane<double>& plane, int width, int height) {
    return sizes(plane.corner) + (width + 2.0 * tile_side) * sizes(plane.right) +
           (height + 2.0 * tile_side) * sizes(plane.up);
}

ViewingPlane<double> scaled(const ViewingPlane<double>& plane, double by) {
    return {by * plane.corner, by * plane.right, by * plane.up};
}

bool is_ordinary(double size) { return size > 0x1p-50 && size < 0x1p50; }

/// The power of two that makes a direction's length ordinary.
double to_ordinary_length(double length) {
    if (is_ordinary(length) || !(length > 0x1p-1000 && length < 0x1p1000)) return 1;
    return std::ldexp(1, -std::ilogb(length));
}

/// Fills in the scales for directions of that size, and surfaces that far from the rays; false if these are not
/// ordinary.
bool set_scales(Grid& grid, double direction, double distance) {
    if (!is_ordinary(direction) || !is_ordinary(distance)) return false;
    grid.distance = std::ldexp(1, std::ilogb(distance) + 1);
    grid.direction_scale = std::ldexp(1, -std::ilogb(direction));
    grid.key_of_t = grid.pinhole ? grid.distance * grid.direction_scale : 1 / (grid.distance * grid.direction_scale);
    return true;
}

}  // namespace

std::optional<Grid> grid(const Vec3<double>& given_eye, const ViewingPlane<double>& given_plane, int width, int height,
                         const Engine& engine) {
    const double to_ordinary = to_ordinary_length(sum_of_sizes(plane_sizes(given_plane, width, height)));
    const Vec3<double> eye = engine.scale() * given_eye;
    const ViewingPlane<double> plane = scaled(given_plane, to_ordinary);
    Grid g;
    g.pinhole = true;
    g.eye = eye;
    g.corner = plane.corner;
    g.right = plane.right;
    g.up = plane.up;
    g.t_scale = engine.scale() / to_ordinary;
    // L and the ray's direction are each rounded five times, relatively to sums of these sizes.
    const Vec3<double> terms = plane_sizes(plane, width, height);
    g.ray_error = 12 * u * sum_of_sizes(terms);
    if (!set_scales(g, sum_of_sizes(terms),
                    static_cast<double>(engine.near_reach()) + greatest_coordinate(eye - engine.middle())))
        return {};
    return g;
}

std::optional<Grid> grid(const Parallel<double>& given, int width, int height, const Engine& engine) {
    const double to_ordinary = to_ordinary_length(sum_of_sizes(given.direction));
    const Parallel<double> view{scaled(given.plane, engine.scale()), to_ordinary * given.direction};
    Grid g;
    g.t_scale = engine.scale() / to_ordinary;
    g.direction = view.direction;
    g.corner = view.plane.corner;
    g.right = view.plane.right;
    g.up = view.plane.up;
    const Vec3<double> terms = plane_sizes(view.plane, width, height);
    g.ray_error = 12 * u * sum_of_sizes(terms);
    const ViewingPlane<double> seen{view.plane.corner - engine.middle(), view.plane.right, view.plane.up};
    if (!set_scales(g, sum_of_sizes(view.direction),
                    static_cast<double>(engine.near_reach()) + greatest_coordinate(plane_sizes(seen, width, height))))
        return {};
    return g;
}

}  // namespace glassbox::engine
