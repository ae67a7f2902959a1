#pragma once
#include <utility>
#include <vector>

#include <rgb.hpp>
#include <sphere.hpp>
#include <triangle.hpp>

#include "scene/scene.hpp"

namespace glassbox {

/// A scene's surfaces in the tracing scalar. Spheres are numbered first, then triangles.
template <class Real>
struct Surfaces {
    std::vector<Sphere<Real>> spheres;
    std::vector<Triangle<Real>> triangles;
};

/// Calls `use` with the sphere or the triangle of that number.
template <class Real, class Use>
auto with_surface(const Surfaces<Real>& surfaces, std::size_t number, const Use& use) {
    const std::size_t spheres = surfaces.spheres.size();
    return number < spheres ? use(surfaces.spheres[number]) : use(surfaces.triangles[number - spheres]);
}

/// The stage from which on all surfaces are known.
inline constexpr int stage_of_all_surfaces = 3;

/// How many spheres and how many triangles a stage knows.
inline std::pair<std::size_t, std::size_t> count_surfaces(const Scene& scene, int stage) {
    std::size_t faces = 0;
    for (const Mesh& mesh : scene.meshes) faces += mesh.faces.size();
    return {stage >= 2 ? scene.spheres.size() : 0, stage >= 3 ? scene.triangles.size() + faces : 0};
}

/// The surfaces that a stage knows: none in the first, spheres from the second, triangles and meshes from the third.
template <class Real>
Surfaces<Real> surfaces(const Scene& scene, int stage) {
    Surfaces<Real> result;
    const auto [spheres, triangles] = count_surfaces(scene, stage);
    result.spheres.reserve(spheres);
    result.triangles.reserve(triangles);
    if (stage >= 2)
        for (const ColoredSphere& sphere : scene.spheres)
            result.spheres.push_back(convert<Real>(Sphere<double>{sphere.center, sphere.radius}));
    if (stage >= 3) {
        const auto add = [&](const Vec3<double>& A, const Vec3<double>& B, const Vec3<double>& C) {
            result.triangles.push_back(convert<Real>(Triangle<double>{A, B, C}));
        };
        for (const auto& [vertices, color] : scene.triangles) add(vertices[0], vertices[1], vertices[2]);
        for (const Mesh& mesh : scene.meshes)
            for (const auto& [a, b, c] : mesh.faces) add(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
    }
    return result;
}

/// The colours of all surfaces, by number.
inline std::vector<Rgb> surface_colors(const Scene& scene) {
    std::vector<Rgb> colors;
    for (const ColoredSphere& sphere : scene.spheres) colors.push_back(sphere.color);
    for (const ColoredTriangle& triangle : scene.triangles) colors.push_back(triangle.color);
    for (const Mesh& mesh : scene.meshes) colors.insert(colors.end(), mesh.faces.size(), mesh.color);
    return colors;
}

}  // namespace glassbox
