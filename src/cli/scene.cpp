#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <span>

#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/tell.hpp"
#include "output/whole_file.hpp"
#include "scene/error.hpp"
#include "scene/scene_file.hpp"
#include "scene/scene_path.hpp"
#include "scene/text_file.hpp"

namespace glassbox {
namespace {

namespace fs = std::filesystem;

struct SceneRequest {
    std::string scene, out;
};

/// The scenes that come with Glassbox, a line each.
void list_scenes() {
    std::vector<fs::path> files;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(shipped_scenes(), none))
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) fmt::print("{:<16} {}\n", file.stem().string(), read_scene(file).title);
    if (::isatty(STDOUT_FILENO)) tell("glassbox scene room -o my/room.toml copies one, to change it");
}

/// Says what a copy in that folder would miss.
void tell_of_meshes(const Scene& scene, const fs::path& from, const fs::path& to) {
    std::error_code none;
    if (scene.meshes.empty() || fs::equivalent(from, to, none)) return;
    tell(fmt::format("it reads meshes beside it: in the copy, write their folder before each file's name: {}",
                     from.string()));
}

/// Throws Error; a file that is there is not replaced.
void copy_scene(const SceneRequest& request) {
    const fs::path from = scene_path(request.scene);
    const std::string text = read_text(from);
    const Scene scene = read_scene(from);
    if (request.out.empty()) {
        print_bytes(text);
        tell_of_meshes(scene, from.parent_path(), fs::current_path());
        return;
    }
    std::error_code none;
    if (fs::is_regular_file(request.out, none))
        throw error_at({request.out},
                       "there is a file of that name, which is not replaced; name another one, or delete it");
    write_whole(request.out, std::as_bytes(std::span(text)));
    tell_of_meshes(scene, from.parent_path(), fs::absolute(request.out).parent_path());
}

}  // namespace

void add_scene(CLI::App& program) {
    const auto request = std::make_shared<SceneRequest>();
    CLI::App* command = program.add_subcommand("scene", "List the scenes that come with Glassbox, or copy one");
    command->add_option("SCENE", request->scene, "the name of one, or a scene file; without it, all are listed");
    add_file(*command, "-o,--out", "FILE.toml", "where to write the copy (default: the terminal)", request->out);
    command->footer("Example: glassbox scene inside -o my/spheres.toml");
    command->callback([request] {
        if (!request->scene.empty()) copy_scene(*request);
        else if (request->out.empty()) list_scenes();
        else
            throw CLI::ValidationError("--out",
                                       "which scene is to be copied? name it: glassbox scene room -o " + request->out);
    });
}

}  // namespace glassbox
