#pragma once
#include <string>

#include "render/options.hpp"

namespace glassbox {

/// "double, tolerance:10, stable": by which scalar and rules a picture is computed.
std::string how_computed(const Options& options);

}  // namespace glassbox
