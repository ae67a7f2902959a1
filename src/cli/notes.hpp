#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "render/options.hpp"

namespace glassbox {

/// "glassbox render: note: …" on stderr, if there is anything to note.
void note(const CLI::App& command, const std::string& text, const std::vector<std::string>& about);

/// What rays are traced for: with a picture's own come its view and its colours.
enum class Rays { of_a_picture, of_ones_own };

/// Which of the options that were typed come to nothing, and why: "--turn (from stage 5)".
std::vector<std::string> unused_options(const CLI::App& command, Rays rays, const Options& options);

}  // namespace glassbox
