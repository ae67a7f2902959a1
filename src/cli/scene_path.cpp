#include "cli/scene_path.hpp"

#include <optional>

namespace glassbox {

namespace fs = std::filesystem;

namespace {

fs::path program() {
    std::error_code none;
#ifdef __APPLE__
    return {};
#else
    return fs::read_symlink("/proc/self/exe", none);
#endif
}

}  // namespace

fs::path shipped_scenes() {
    const fs::path bin = program().parent_path();
    for (const fs::path& folder : {bin / "../share/glassbox/scenes", fs::path(GLASSBOX_SCENES)}) {
        std::error_code none;
        if (fs::is_directory(folder, none)) return folder.lexically_normal();
    }
    return {};
}

fs::path scene_path(const std::string& typed) {
    std::error_code none;
    const fs::path as_typed(typed);
    if (typed.empty() || fs::exists(as_typed, none)) return as_typed;
    const bool names_a_shipped_one = !as_typed.has_parent_path() || as_typed.parent_path() == fs::path("scenes");
    const fs::path folder = shipped_scenes();
    if (!names_a_shipped_one || folder.empty()) return as_typed;
    fs::path shipped = folder / as_typed.filename();
    if (fs::exists(shipped, none)) return shipped;
    shipped += ".toml";
    return fs::exists(shipped, none) ? shipped : as_typed;
}

}  // namespace glassbox
