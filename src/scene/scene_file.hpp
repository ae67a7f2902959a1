#pragma once
#include <filesystem>

#include "scene/scene.hpp"

namespace glassbox {

/// Reads the scene of a TOML file (docs/scene-format.md) and loads its meshes. Throws Error with file, line and column
/// for anything that is not as it should be.
Scene read_scene(const std::filesystem::path& file);

}  // namespace glassbox
