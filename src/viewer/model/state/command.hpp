#pragma once
#include <filesystem>
#include <string>

#include "render/pixel.hpp"
#include "render/setup.hpp"

namespace glassbox {

/// The command line that tells the same pixel's story: `glassbox explain FILE … --pixel X,Y`, with an option for all in
/// which the setup differs from what the scene says.
std::string explain_command(const std::filesystem::path& file, const Scene& scene, const Setup& setup, Pixel pixel);

}  // namespace glassbox
