#pragma once
#include <cstddef>

#include "learn/picture/sheet.hpp"
#include "render/options.hpp"
#include "scene/scene.hpp"

namespace glassbox::learn::mine {

/// How many triangles a scene has, with those of its meshes.
std::size_t triangles_of(const Scene& scene);

/// Writes what there is to trace, as plain numbers. The sheet must have room for its lists.
void write(const Scene& scene, const Options& options, Sheet& sheet);

}  // namespace glassbox::learn::mine
