#include "viewer/ui/frame/thumbnail_textures.hpp"

#include "viewer/ui/picture/pictures.hpp"

namespace glassbox {

void ThumbnailTextures::update(const Results& results) {
    if (updated_ == results.thumbnails) return;
    updated_ = results.thumbnails;
    for (const auto& [file, thumbnail] : *updated_) {
        Shown& shown = shown_[file];
        if (shown.image == thumbnail.image) continue;
        shown.image = thumbnail.image;
        if (shown.image) shown.texture.fill(shown.image->width, shown.image->height, opaque(*shown.image));
    }
}

const Texture* ThumbnailTextures::of(const std::filesystem::path& file) const {
    const auto found = shown_.find(file);
    return found == shown_.end() || !found->second.image ? nullptr : &found->second.texture;
}

}  // namespace glassbox
