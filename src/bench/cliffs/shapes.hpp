#pragma once
#include <cstdint>
#include <vector>

#include <ray.hpp>

#include "bench/meshes.hpp"
#include "bench/random.hpp"
#include "scene/scene.hpp"

/// What the scenes of cliffs are made of.
namespace glassbox::shape {

inline constexpr Rgb grey{200, 200, 200};

/// A square picture from `eye`.
Scene seen_from(const Vec3<double>& eye, const Vec3<double>& look_at, int side);

/// A square picture by parallel rays along −z, `width` wide; the rays of column j and row i start at (j, i) · width /
/// side, exactly so where side and width are powers of two, plus `shift` in x and half of it in y.
Scene seen_from_above(double width, int side, double shift = 0);

/// The rays of a scene's picture, row by row.
std::vector<Ray<double>> picture_rays(const Scene& scene);

Scene with(Scene scene, Mesh mesh);
Scene with(Scene scene, const ColoredSphere& sphere);
Scene with(Scene scene, const ColoredTriangle& triangle);

/// The ordinary scene: hills that fill the picture, about as many triangles as asked for.
Scene hills(double triangles, int side);

/// A knot of 2 · around · 12 triangles, its points multiplied by `scale` and then moved; seen from the front.
Scene knot(std::uint32_t around, int side, double scale = 1, const Vec3<double>& moved = {});

/// As many spheres of radius 0.4 as `many`³, at the points of a cubic lattice that random steps have disturbed, with
/// corners at 0 and many − 1.
Scene loose_balls(int many, Scene scene);

Mesh moved(Mesh mesh, double scale, const Vec3<double>& by);

/// n triangles of their own, each corner of each from `corner(i, 0..2)`.
template <class Corner>
Mesh separate_triangles(std::uint32_t n, const Corner& corner) {
    Mesh mesh{{}, {}, grey};
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t k = 0; k < 3; ++k) mesh.vertices.push_back(corner(i, k));
        mesh.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return mesh;
}

inline Vec3<double> random_point(Random& random, double least, double greatest) {
    const double x = random.between(least, greatest), y = random.between(least, greatest);
    return {x, y, random.between(least, greatest)};
}

}  // namespace glassbox::shape
