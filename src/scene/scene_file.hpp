#pragma once
#include <filesystem>

#include "scene/scene.hpp"

namespace glassbox {

/// The scene that a TOML file describes (docs/scene-format.md), its meshes loaded. Throws
/// Error with file, line and column for anything that is not as it should be.
Scene read_scene(const std::filesystem::path& file);

}  // namespace glassbox
