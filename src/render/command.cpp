#include "render/command.hpp"

#include <fmt/format.h>

#include "scene/scene_path.hpp"
#include "scene/shell_word.hpp"

namespace glassbox {

namespace {

/// A file's name that is not taken for an option.
std::string file_word(const std::string& name) { return shell_word(name.starts_with('-') ? "./" + name : name); }

std::string begun(std::string_view verb, const SceneWords& scene) {
    std::string line = fmt::format("glassbox {} {}", verb, file_word(scene_word(scene.file)));
    if (scene.size) line += fmt::format(" --size {}x{}", scene.size->first, scene.size->second);
    for (const Parameter* parameter : scene.told) {
        line += fmt::format(" --{}", parameter->name);
        if (const std::string value = written(*parameter, scene.setup); !value.empty()) line += ' ' + shell_word(value);
    }
    return line;
}

}  // namespace

std::vector<const Parameter*> differing(const Setup& setup, const Setup& original) {
    std::vector<const Parameter*> different;
    for (const Parameter& parameter : parameters())
        if (!is_same(parameter, setup, original)) different.push_back(&parameter);
    return different;
}

std::string explain_command(const SceneWords& scene, Pixel pixel) {
    return begun("explain", scene) + fmt::format(" --pixel {},{}", pixel.x, pixel.y);
}

std::string explain_ray_command(const SceneWords& scene, const Ray<double>& ray) {
    const auto& [P, D] = ray;
    return begun("explain", scene) + fmt::format(" --ray {},{},{},{},{},{}", P.x, P.y, P.z, D.x, D.y, D.z);
}

std::string render_command(const SceneWords& scene, std::string_view extension) {
    return begun("render", scene) + " -o " + file_word(usual_name(scene.file, {}, extension));
}

std::string measure_command(const SceneWords& scene, const MeasureWords& measured, std::string_view extension) {
    std::string line = begun("measure", scene) + fmt::format(" --what {}", fmt::join(measured.what, ","));
    if (measured.minus) line += " --minus " + shell_word(written(*measured.minus));
    if (measured.spacing)
        line +=
            fmt::format(" --scale {}", name_where(spacings, [&](Spacing each) { return each == measured.spacing; }));
    return line + " -o " + file_word(usual_name(scene.file, measured.what, extension, measured.minus));
}

std::string view_command(const SceneWords& scene, std::string_view more) { return begun("view", scene).append(more); }

std::string usual_name(const std::filesystem::path& scene, std::span<const std::string_view> what,
                       std::string_view ending, const Minus* minus) {
    std::string name = scene.stem().string();
    for (const std::string_view each : what)
        name.append("-").append(minus ? difference_file_name(each, *minus) : std::string(each));
    return name.append(ending);
}

}  // namespace glassbox
