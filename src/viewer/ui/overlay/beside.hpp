#pragma once
#include <string>

#include "render/options.hpp"

namespace glassbox {

/// Returns the scalar and rules that a picture is computed with: "double, tolerance:10, stable".
std::string how_computed(const Options& options);

}  // namespace glassbox
