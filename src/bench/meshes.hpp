#pragma once
#include <cstdint>

#include "scene/scene.hpp"

namespace glassbox {

// Meshes for benchmarks, the same on every machine. Their vertices are floats, so that a single-precision tracer gets
// the same surfaces.

/// A tube around a trefoil knot: 2 · around · across triangles.
Mesh trefoil(std::uint32_t around, std::uint32_t across);

/// A sphere of radius 1 about the origin: 20 · 4^splits triangles, each corner on the sphere.
Mesh icosphere(int splits);

/// Hills over a square of side 2, cells · cells · 2 triangles.
Mesh terrain(std::uint32_t cells);

/// A mesh seen through a pinhole at `eye` that looks at `look_at`, 1024 x 1024 pixels.
Scene seen(Mesh mesh, const Vec3<double>& eye, const Vec3<double>& look_at);

/// A terrain of a million triangles, seen so.
Scene a_million_triangles();

}  // namespace glassbox
