#pragma once
#include <ray.hpp>

#include "oracle/oracle.hpp"
#include "scene/scene.hpp"

/// Converts the program's scenes and rays to the oracle's.
namespace glassbox::test {

inline oracle::Point to_oracle(const Vec3<double>& v) { return {v.x, v.y, v.z}; }
inline oracle::Ray to_oracle(const Ray<double>& ray) { return {to_oracle(ray.P), to_oracle(ray.D)}; }

inline oracle::Surfaces surfaces_of(const Scene& scene) {
    oracle::Surfaces surfaces;
    const auto add = [&](const Vec3<double>& A, const Vec3<double>& B, const Vec3<double>& C) {
        surfaces.triangles.push_back({to_oracle(A), to_oracle(B), to_oracle(C)});
    };
    for (const ColoredSphere& sphere : scene.spheres)
        surfaces.spheres.push_back({to_oracle(sphere.center), sphere.radius});
    for (const auto& [vertices, color] : scene.triangles) add(vertices[0], vertices[1], vertices[2]);
    for (const Mesh& mesh : scene.meshes)
        for (const auto& [a, b, c] : mesh.faces) add(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
    return surfaces;
}

}  // namespace glassbox::test
