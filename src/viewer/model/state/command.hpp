#pragma once
#include <string>
#include <string_view>

#include "render/command.hpp"
#include "viewer/model/state/state.hpp"

namespace glassbox {

// The command lines of what the viewer shows, with an option for all in which it differs from what the scene file says.

/// A setup of a scene file.
SceneWords words_of(const std::filesystem::path& file, const Scene& scene, const Setup& setup);

/// Shows the same again in the viewer: scene and setup, the pin, the overlay, the learner's picture.
std::string command_to_view(const ViewerState& state);

/// Draws the picture into a file, of the setup that is seen or of another one.
std::string command_to_render(const ViewerState& state, std::string_view extension);
std::string command_to_render(const ViewerState& state, const Setup& setup, std::string_view extension);

/// Measures what the overlay shows into a file; there must be one.
std::string command_to_measure(const ViewerState& state, std::string_view extension);

/// Tells a pixel's story.
std::string command_to_explain(const ViewerState& state, Pixel pixel);

}  // namespace glassbox
