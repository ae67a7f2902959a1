#pragma once
#include <cstdint>
#include <filesystem>

namespace glassbox {

/// When a file was written and how large it is: what tells that it has changed.
struct FileVersion {
    std::filesystem::file_time_type written{};
    std::uintmax_t size = 0;

    bool operator==(const FileVersion&) const = default;
};

/// The version of no file, FileVersion{}, if it is not there: an editor may remove it for a moment while it writes.
FileVersion file_version(const std::filesystem::path& file);

}  // namespace glassbox
