#include "viewer/model/files/file_version.hpp"

namespace glassbox {

FileVersion file_version(const std::filesystem::path& file) {
    std::error_code gone;
    FileVersion now;
    now.written = std::filesystem::last_write_time(file, gone);
    if (gone) return {};
    now.size = std::filesystem::file_size(file, gone);
    return gone ? FileVersion{} : now;
}

}  // namespace glassbox
