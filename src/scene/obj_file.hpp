#pragma once
#include <filesystem>

#include "scene/scene.hpp"

namespace glassbox {

/// Reads the surface of a Wavefront OBJ file, in one colour. Uses its vertices (v) and faces (f, fo): faces in file
/// order, whatever group or object they belong to, with polygons cut into triangles. Refuses free-form surfaces.
/// Ignores normals, texture, materials, points, lines and all else. Throws Error with file, line and column.
Mesh read_obj(const std::filesystem::path& file, const Rgb& color);

}  // namespace glassbox
