#include <cmath>
#include <numbers>

#include "bench/cliffs/cliff.hpp"
#include "bench/cliffs/shapes.hpp"

namespace glassbox {

namespace {

using namespace shape;

/// side × side rays along −z, from that height, over a square in which the knot is.
std::vector<Ray<double>> rays_along_z(double height, int side, const Vec3<double>& direction) {
    std::vector<Ray<double>> rays;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            rays.push_back({{2.0 * x / side - 1 + 0.003, 2.0 * y / side - 1 + 0.003, height}, direction});
    return rays;
}

Traced shot(Scene scene, std::vector<Ray<double>> rays) { return {std::move(scene), std::move(rays)}; }

Traced along_z(double height, double sideways, int side) {
    return shot(knot(128, side), rays_along_z(height, side, {sideways, 0.01, -1}));
}

Traced straight(double height, int side) { return shot(knot(128, side), rays_along_z(height, side, {0, 0, -1})); }

/// Rays about a knot of so few triangles that `shoot` takes the plain loop; one of them starts at `far`.
Traced one_far(double far, int side) {
    std::vector<Ray<double>> rays = rays_along_z(4, side, {0.02, 0.01, -1});
    rays.front().P.z = far;
    return shot(knot(32, side), std::move(rays));
}
Traced one_far_of_many(double far, int side) {
    std::vector<Ray<double>> rays = rays_along_z(4, side, {0.02, 0.01, -1});
    rays.front().P.z = far;
    return shot(knot(128, side), std::move(rays));
}

/// Rays in the plane of a mesh of 3,200 triangles, all of whose side products are 0; or not quite in it.
Traced in_plane(double tilt, int side) {
    Mesh mesh = terrain(40);
    for (Vec3<double>& v : mesh.vertices) v.z = 0;
    std::vector<Ray<double>> rays;
    for (int i = 0; i < side * side; ++i)
        rays.push_back({{-2, 1.9 * i / (side * side) - 0.93, 1.5 * tilt}, {1, 0.05, -tilt}});
    return shot(with(seen_from({0, 0, 4}, {0, 0, 0}, side), std::move(mesh)), std::move(rays));
}

/// A fan of 2,400 triangles about one corner, the origin; all rays pass through that corner exactly, or beside it.
Traced through_corner(double aside, int side) {
    constexpr std::uint32_t count = 2400;
    const auto corner = [](std::uint32_t i, std::uint32_t k) {
        const double angle = 2 * std::numbers::pi * (i + (k == 2)) / count;
        return k == 0 ? Vec3<double>{} : Vec3<double>{std::cos(angle), std::sin(angle), 0};
    };
    std::vector<Ray<double>> rays = rays_along_z(4, side, {});
    for (auto& [P, D] : rays) D = Vec3<double>{aside, aside, 0} - P;
    return shot(with(seen_from({0, 0, 4}, {0, 0, 0}, side), separate_triangles(count, corner)), std::move(rays));
}

/// Rays whose directions are so long.
Traced of_length(double length, int side) {
    return shot(knot(128, side), rays_along_z(4, side, length * Vec3<double>{0.02, 0.01, -1}));
}

Cliff any(std::string name, double goal, std::string ordinary, std::function<Traced(int)> make,
          std::function<Traced(int)> make_ordinary) {
    return {"shoot: " + std::move(name), goal, std::move(ordinary), std::move(make), std::move(make_ordinary)};
}

}  // namespace

std::vector<Cliff> cliffs_of_rays() {
    const auto usual = [](int side) { return along_z(4, 0.02, side); };
    return {
        any(
            "a direction component of 1e-19", 3, "one of 0.02", [](int side) { return along_z(4, 1e-19, side); },
            usual),
        any(
            "a start at 2e18", 3, "one at 4", [](int side) { return straight(2e18, side); },
            [](int side) { return straight(4, side); }),
        any(
            "one ray at 1e18 among ordinary ones, 768 triangles", 1.1, "all ordinary",
            [](int side) { return one_far(1e18, side); }, [](int side) { return one_far(4, side); }),
        any(
            "one ray at 1e18 among ordinary ones, 3,072 triangles", 1.1, "all ordinary",
            [](int side) { return one_far_of_many(1e18, side); }, [](int side) { return one_far_of_many(4, side); }),
        any(
            "directions of length 1e-30", 3, "of length 1", [](int side) { return of_length(1e-30, side); }, usual),
        any(
            "directions of length 1e200", 3, "of length 1", [](int side) { return of_length(1e200, side); }, usual),
        any(
            "rays through the corner of 2,400 triangles", 10, "rays beside it",
            [](int side) { return through_corner(0, side); }, [](int side) { return through_corner(0.3, side); }),
        any(
            "rays in the plane of 3,200 triangles", 10, "rays through it", [](int side) { return in_plane(0, side); },
            [](int side) { return in_plane(0.7, side); }),
    };
}

}  // namespace glassbox
