#include "read_drawn.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "scene/scene_file.hpp"

namespace glassbox::fuzz {

Scene read_drawn(const Drawn& drawn) {
    const auto path = std::filesystem::temp_directory_path() / ("glassbox-fuzz-" + std::to_string(getpid()) + ".toml");
    std::ofstream(path) << to_toml(drawn);
    struct Removed {
        const std::filesystem::path& path;
        ~Removed() { std::filesystem::remove(path); }
    } const removed{path};
    return read_scene(path);
}

}  // namespace glassbox::fuzz
