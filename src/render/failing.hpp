#pragma once
#include <optional>

#include "render/setup.hpp"

namespace glassbox {

/// The setup with which the scene's numbers fail, as its file says; none if it says nothing. Throws Error, with the
/// place in the file, where it says what cannot be.
std::optional<Setup> failing_setup(const Scene& scene, Setup setup);

}  // namespace glassbox
