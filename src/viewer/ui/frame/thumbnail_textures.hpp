#pragma once
#include <filesystem>
#include <map>
#include <memory>

#include "viewer/model/work/results.hpp"
#include "viewer/platform/texture.hpp"

namespace glassbox {

/// The small pictures of scene files as textures; updated when there is a newer one.
class ThumbnailTextures {
public:
    void update(const Results& results);

    /// Null: there is none of that file.
    const Texture* of(const std::filesystem::path& file) const;

private:
    struct Shown {
        std::shared_ptr<const Image> image;
        Texture texture;
    };
    std::shared_ptr<const Thumbnails> updated_;
    std::map<std::filesystem::path, Shown> shown_;
};

}  // namespace glassbox
