#pragma once
#include <string_view>

#include "explain/story.hpp"

namespace glassbox {

// Words shared by text and JSON.

std::string_view word(Operation operation);
std::string_view word(Known known);
std::string_view word(story::Kind kind);
std::string_view word(story::Fate fate);

/// "core/2-spheres/sphere.hpp": a file of ours, from the folder `src` on.
std::string_view source(std::string_view file);

}  // namespace glassbox
