#pragma once
#include <filesystem>

#include "scene/scene.hpp"

namespace glassbox {

/// The surface that a Wavefront OBJ file describes, in one colour. Of the file, vertices (v) and faces (f, fo)
/// count: faces in file order, whatever group or object they belong to, polygons cut into triangles. Free-form surfaces
/// are refused. Normals, texture, materials, points, lines and all else are passed over. Throws Error with file, line
/// and column.
Mesh read_obj(const std::filesystem::path& file, const Rgb& color);

}  // namespace glassbox
