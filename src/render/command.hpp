#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <ray.hpp>

#include "render/measure/minus.hpp"
#include "render/measure/spacing.hpp"
#include "render/parameters.hpp"
#include "render/pixel.hpp"

namespace glassbox {

// Command lines that can be pasted into a shell. What the program writes, prints or copies to be run again is one of
// these.

/// A scene file, and what is changed of it: what a command line says after its verb.
struct SceneWords {
    std::filesystem::path file;
    std::optional<std::pair<int, int>> size{};  ///< of the picture, if it is not the file's own
    Setup setup{};
    std::vector<const Parameter*> told{};  ///< the parts of the setup that become options
};

/// The parameters in which the setups differ, in the order of the table.
std::vector<const Parameter*> differing(const Setup& setup, const Setup& original);

/// "glassbox explain room --scalar float --pixel 3,4"
std::string explain_command(const SceneWords& scene, Pixel pixel);

/// "glassbox explain room --scalar float --ray 0,0,0,1,0,0"
std::string explain_ray_command(const SceneWords& scene, const Ray<double>& ray);

/// "glassbox render room --turn z:10 -o room.png", into the current folder; `extension` is ".png".
std::string render_command(const SceneWords& scene, std::string_view extension);

/// What a command line says of measurements after the scene.
struct MeasureWords {
    std::span<const std::string_view> what;
    SetSpacing spacing = {};
    const Minus* minus = nullptr;  ///< null: nothing is subtracted
};

/// "glassbox measure room --what depth,n.l -o room-depth-n.l.csv"
std::string measure_command(const SceneWords& scene, const MeasureWords& measured, std::string_view extension);

/// "glassbox view room --turn z:10" and the options that follow.
std::string view_command(const SceneWords& scene, std::string_view more);

/// The name of a picture, or of measurements, of that scene: "room-depth.csv"; `ending` is ".csv".
/// With `minus` they are differences.
std::string usual_name(const std::filesystem::path& scene, std::span<const std::string_view> what,
                       std::string_view ending, const Minus* minus = nullptr);

}  // namespace glassbox
