#pragma once
#include <cstddef>

#include "explain/story.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// What kind of surface has that number.
inline story::Kind kind_of(const Scene& scene, std::size_t number) {
    if (number < scene.spheres.size()) return story::Kind::sphere;
    return number < scene.spheres.size() + scene.triangles.size() ? story::Kind::triangle : story::Kind::mesh_face;
}

}  // namespace glassbox
