#include "scene/scene_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "scene/error.hpp"
#include "scene/shipped.hpp"
#include "scene/suggestion.hpp"

namespace glassbox {

namespace fs = std::filesystem;

namespace {

/// The scene that comes with Glassbox of that name, with or without folder and ending; empty if there is none.
fs::path shipped_scene(const fs::path& name) {
    const fs::path folder = shipped_scenes();
    const bool may_be = !name.has_parent_path() || name.parent_path() == fs::path("scenes");
    if (folder.empty() || !may_be || !name.has_filename()) return {};
    std::error_code none;
    for (const char* ending : {"", ".toml"}) {
        fs::path shipped = folder / name.filename();
        shipped += ending;
        if (fs::is_regular_file(shipped, none)) return shipped;
    }
    return {};
}

/// "fan", "room": the scenes that come with Glassbox.
std::vector<std::string> shipped_names() {
    std::vector<std::string> names;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(shipped_scenes(), none))
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

Error no_such_scene(const std::string& typed) {
    const std::vector<std::string> names = shipped_names();
    const std::string near = did_you_mean(fs::path(typed).stem().string(), names);
    const std::string with_glassbox = fmt::format("with Glassbox come '{}'", fmt::join(names, "', '"));
    return error_at({typed.empty() ? "\"\"" : typed},
                    "there is no such file" + (names.empty() ? "" : "; " + (near.empty() ? with_glassbox : near)));
}

}  // namespace

fs::path shipped_scenes() {
    const fs::path folder = shipped_folder();
    return folder.empty() ? folder : folder / "scenes";
}

fs::path scene_path(const std::string& typed) {
    std::error_code none;
    fs::path as_typed(typed);
    if (fs::exists(as_typed, none) && !fs::is_directory(as_typed, none)) return as_typed;
    if (const fs::path shipped = shipped_scene(as_typed); !shipped.empty()) return shipped;
    if (fs::is_directory(as_typed, none)) return as_typed;
    throw no_such_scene(typed);
}

std::string scene_word(const fs::path& file) {
    std::error_code none;
    const std::string name = file.stem().string();
    const bool is_shipped =
        file.extension() == ".toml" && fs::equivalent(file, shipped_scenes() / file.filename(), none);
    return is_shipped && !fs::exists(name, none) ? name : file.string();
}

}  // namespace glassbox
