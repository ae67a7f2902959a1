#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "render/image.hpp"
#include "viewer/model/files/file_version.hpp"

namespace glassbox {

struct Job;

/// A scene file at a glance.
struct Thumbnail {
    FileVersion version;                 ///< of the file that it shows
    std::shared_ptr<const Image> image;  ///< null: the file is no scene, and `error` says why
    std::string title, error;
};

using Thumbnails = std::map<std::filesystem::path, Thumbnail>;

inline constexpr int thumbnail_width = 96, thumbnail_height = 72;  ///< at most, in pixels

/// Reads a scene file and draws it small, as `render` does.
Thumbnail thumbnail(const std::filesystem::path& file, const FileVersion& version, const Job& job);

}  // namespace glassbox
