#include "scene/shipped.hpp"

namespace glassbox {

namespace fs = std::filesystem;

fs::path program_folder() {
    std::error_code none;
#ifdef __APPLE__
    return {};
#else
    return fs::read_symlink("/proc/self/exe", none).parent_path();
#endif
}

fs::path shipped_folder() {
    for (const fs::path& folder : {program_folder() / "../share/glassbox", fs::path(GLASSBOX_SOURCE_DIR)}) {
        std::error_code none;
        if (fs::is_directory(folder / "scenes", none)) return folder.lexically_normal();
    }
    return {};
}

fs::path here_or_shipped(const fs::path& named) {
    std::error_code none;
    if (named.is_absolute() || fs::exists(named, none)) return named;
    const fs::path shipped = shipped_folder() / named;
    return fs::is_regular_file(shipped, none) ? shipped : named;
}

}  // namespace glassbox
