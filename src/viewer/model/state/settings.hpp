#pragma once
#include <filesystem>
#include <vector>

#include "viewer/model/state/state.hpp"

namespace glassbox {

/// What the viewer remembers from one run to the next.
struct Settings {
    Appearance appearance;
    float side_width = 0.4f, space_height = 0.28f;
    bool space_shown = true;
    int window_width = 1280, window_height = 800;
    std::vector<std::filesystem::path> recent;  ///< scenes, the newest first

    bool operator==(const Settings&) const = default;
};

/// Returns where the settings are kept: $XDG_CONFIG_HOME/glassbox/viewer.json, or .config/glassbox/viewer.json in the
/// home folder; empty if there is neither.
std::filesystem::path settings_file();

/// Reads the settings from a file. Missing or invalid values get their defaults: a damaged file must not keep the
/// viewer from starting.
Settings read_settings(const std::filesystem::path& file);

/// Throws Error if it cannot be written.
void write_settings(const std::filesystem::path& file, const Settings& settings);

Settings settings_of(const ViewerState& state, int window_width, int window_height);
void remember(ViewerState& state, const Settings& settings);

}  // namespace glassbox
