#include "viewer/model/state/command.hpp"

#include <fmt/format.h>

#include "explain/shell_word.hpp"
#include "render/parameters.hpp"

namespace glassbox {

std::string explain_command(const std::filesystem::path& file, const Scene& scene, const Setup& setup, Pixel pixel) {
    std::string line = "glassbox explain " + shell_word(file.string());
    const Setup original = setup_of(scene);
    for (const Parameter& parameter : parameters()) {
        if (is_same(parameter, setup, original)) continue;
        line += fmt::format(" --{}", parameter.name);
        if (const std::string value = written(parameter, setup); !value.empty()) line += ' ' + value;
    }
    return line + fmt::format(" --pixel {},{}", pixel.x, pixel.y);
}

}  // namespace glassbox
