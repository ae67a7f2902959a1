#pragma once
#include "drawn.hpp"
#include "scene/scene.hpp"

namespace glassbox::fuzz {

/// Reads a scene as the program does, from a file: any refusal is the program's.
Scene read_drawn(const Drawn& drawn);

}  // namespace glassbox::fuzz
