#include "viewer/model/state/command.hpp"

#include <fmt/format.h>

#include "explain/shell_word.hpp"
#include "render/option_names.hpp"
#include "scene/shading_models.hpp"

namespace glassbox {

namespace {

std::string turns(const Options& options) {
    std::string list;
    for (const auto& [axis, degrees] : options.turns)
        list += fmt::format("{}{}:{}", list.empty() ? "" : ",", "xyz"[static_cast<int>(axis)], degrees);
    return list;
}

}  // namespace

std::string explain_command(const std::filesystem::path& file, const Scene& scene, const Setup& setup, Pixel pixel) {
    std::string line = "glassbox explain " + shell_word(file.string());
    const Setup original = setup_of(scene);
    const auto add = [&](const char* option, const auto& value, const auto& usual) {
        if (value != usual) line += fmt::format(" --{} {}", option, value);
    };
    const auto& [options, shading, light, intensity] = setup;
    add("stage", options.stage, original.options.stage);
    add("turn", turns(options), std::string());
    if (options.accumulated) line += " --accumulated";
    add("ambient", shading.k_a, original.shading.k_a);
    add("diffuse", shading.k_d, original.shading.k_d);
    add("specular", shading.k_s, original.shading.k_s);
    add("exponent", shading.exponent, original.shading.exponent);
    add("shading", name_of(shading.model), name_of(original.shading.model));
    if (light != original.light_vector) line += fmt::format(" --light {},{},{}", light.x, light.y, light.z);
    add("intensity", intensity, original.light_intensity);
    add("scalar", name_of(options.scalar), name_of(original.options.scalar));
    add("triangle", written(options.triangle_rule), written(original.options.triangle_rule));
    add("sphere", name_of(options.sphere_rule), name_of(original.options.sphere_rule));
    return line + fmt::format(" --pixel {},{}", pixel.x, pixel.y);
}

}  // namespace glassbox
