#include "viewer/platform/texture.hpp"

#include <fmt/format.h>

#include <cassert>
#include <utility>

#include "render/pixel.hpp"
#include "scene/error.hpp"
#include "viewer/platform/opengl.hpp"

namespace glassbox {
namespace {

GLuint make_texture() {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return name;
}

void check_size(int width, int height) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (width > most || height > most)
        throw Error(
            fmt::format("a picture of {}x{} cannot be shown: OpenGL takes {}x{} here at most; render it smaller", width,
                        height, most, most));
}

}  // namespace

Texture::Texture(Texture&& other) noexcept { *this = std::move(other); }

Texture& Texture::operator=(Texture&& other) noexcept {
    std::swap(name_, other.name_);
    std::swap(width_, other.width_);
    std::swap(height_, other.height_);
    return *this;
}

Texture::~Texture() {
    if (name_ != 0) glDeleteTextures(1, &name_);
}

void Texture::fill(int width, int height, std::span<const Rgba> pixels) {
    assert(pixels.size() == pixel_count(width, height));
    check_size(width, height);
    if (name_ == 0) name_ = make_texture();
    glBindTexture(GL_TEXTURE_2D, name_);
    if (width == width_ && height == height_)
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    else glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    width_ = width;
    height_ = height;
}

ImTextureID Texture::id() const {
    // An integer since Dear ImGui 1.91.4, a pointer before.
#if IMGUI_VERSION_NUM >= 19140
    return static_cast<ImTextureID>(name_);
#else
    return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(name_));
#endif
}

}  // namespace glassbox
