#pragma once
#include <CLI/CLI.hpp>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "render/command.hpp"
#include "render/parameters.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// What the command line of `render`, `measure` and `shoot` asks for: a scene, how to trace it, and what to change of
/// it.
struct Request {
    std::string scene;
    Setup setup;                          ///< what of it is typed counts
    std::vector<const Parameter*> typed;  ///< of all but flags; of the shading the rest is as the scene says
    int threads = 0;                      ///< 0: all cores
    std::optional<std::pair<int, int>> size;
};

/// Gives a subcommand the SCENE argument and the options that all of them share.
void add_scene_options(CLI::App& command, Request& request);

/// Gives a subcommand the options of all parameters, those of the view, of shading and of computing.
void add_parameters(CLI::App& command, Request& request);

/// The same setup with what is typed.
Setup typed_setup(const Request& request, Setup setup);

/// Gives a subcommand an option that names a file.
CLI::Option* add_file(CLI::App& command, const char* option, const char* value, const char* help, std::string& file);

/// The scene that is asked for, with its changes. Throws Error.
Scene load(const Request& request);

/// How a command line asks for it again. Throws Error if there is no such scene.
SceneWords scene_words(const Request& request);

/// The options that say how pixels become rays.
inline constexpr std::array<std::string_view, 3> pixels_to_rays{"size", "turn", "accumulated"};

/// The same where rays of one's own are asked about: without what makes pixels into rays.
SceneWords words_of_own_rays(const Request& request);

}  // namespace glassbox
