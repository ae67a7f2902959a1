#include "engine/tile.hpp"

#include <algorithm>
#include <cmath>

namespace glassbox::engine {

namespace {

constexpr double u = 0x1p-53;

Vec3<double> sizes(const Vec3<double>& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }
double sum(const Vec3<double>& v) { return v.x + v.y + v.z; }
double greatest(const Vec3<double>& v) { return std::max({v.x, v.y, v.z}); }

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

/// Fills in the scales for directions of that size, and vertices that far from the rays; false if these are not
/// ordinary.
bool set_scales(Grid& grid, double direction, double distance) {
    if (!is_ordinary(direction) || !is_ordinary(distance)) return false;
    const int e = std::ilogb(distance) + 1;
    grid.direction_scale = std::ldexp(1, -2 * e - std::ilogb(direction));
    grid.farthest = std::ldexp(1, e + 50);  // side products are then less than 2¹⁰⁴
    grid.key_scale = std::ldexp(1, grid.pinhole ? 3 * e : -3 * e);
    grid.key_of_t = grid.pinhole ? grid.key_scale * grid.direction_scale : grid.key_scale / grid.direction_scale;
    return true;
}

}  // namespace

std::optional<Grid> grid(const Vec3<double>& given_eye, const ViewingPlane<double>& given_plane, int width, int height,
                         const Engine& engine) {
    const double to_ordinary = to_ordinary_length(sum(plane_sizes(given_plane, width, height)));
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
    g.ray_error = 12 * u * sum(terms);
    const double direction = sum(terms);
    if (!set_scales(g, direction, static_cast<double>(engine.near_reach()) + greatest(sizes(eye - engine.middle()))))
        return {};
    const double steps = 4 * (sum(sizes(g.right)) + sum(sizes(g.up)));
    // A side product's terms add up to at most 2m²|D|, each rounded seven times; and B × A is at most 2m² along each
    // axis.
    g.side1 = g.direction_scale * (20 * u * (direction + steps) + 2 * g.ray_error);
    g.volume1 = 60 * u;  // the terms of |A B C| add up to 6m³, each rounded eight times
    return g;
}

std::optional<Grid> grid(const Parallel<double>& given, int width, int height, const Engine& engine) {
    const double to_ordinary = to_ordinary_length(sum(sizes(given.direction)));
    const Parallel<double> view{scaled(given.plane, engine.scale()), to_ordinary * given.direction};
    Grid g;
    g.t_scale = engine.scale() / to_ordinary;
    g.direction = view.direction;
    g.corner = view.plane.corner;
    g.right = view.plane.right;
    g.up = view.plane.up;
    const Vec3<double> terms = plane_sizes(view.plane, width, height);
    g.ray_error = 12 * u * sum(terms);
    const double direction = sum(sizes(view.direction)), thickest = greatest(sizes(view.direction));
    const ViewingPlane<double> seen{view.plane.corner - engine.middle(), view.plane.right, view.plane.up};
    if (!set_scales(g, direction,
                    static_cast<double>(engine.near_reach()) + greatest(plane_sizes(seen, width, height))))
        return {};
    const double steps = 4 * (sum(sizes(g.right)) + sum(sizes(g.up)));
    g.side1 = g.direction_scale * 20 * u * direction;
    // B − A is at most 2m along each axis, and off by 4um; (B − A) × D at most 4m|D|, and off by 20um|D|; times a step,
    // by 32um|D| of it.
    g.side2 = g.direction_scale * (40 * u * steps + 4 * g.ray_error) * thickest;
    g.volume1 = 60 * u;
    // |A B C| changes along the steps by their product with A × B + B × C + C × A: at most 6m² along each axis, off by
    // 36um², with the step by 54um².
    g.volume2 = 60 * u * steps + 6 * g.ray_error;
    return g;
}

}  // namespace glassbox::engine
