#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "render/measurements.hpp"
#include "render/options.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// "glassbox render: note: …" on stderr, if there is anything to note.
void note(const CLI::App& command, const std::string& text, const std::vector<std::string>& about);

/// What rays are traced for: with a picture's own come its view and its colours.
enum class Rays { of_a_picture, of_ones_own };

/// Which of the options that were typed come to nothing, and why: "--turn (from stage 5)".
std::vector<std::string> unused_options(const CLI::App& command, Rays rays, int stage);

/// Why a measurement has no value at any pixel: "phong has no half vector".
std::string why_no_value(const Measurement& what, const Scene& scene, const Options& options);

}  // namespace glassbox
