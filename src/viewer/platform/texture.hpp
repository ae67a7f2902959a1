#pragma once
#include <cstdint>
#include <span>

#include <imgui.h>

namespace glassbox {

/// Colour and opacity, 0 to 255 each, as OpenGL takes them.
struct Rgba {
    std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;
};

/// A picture in graphics memory, drawn with hard pixel edges, and smoothed where it is reduced. It must be made, filled
/// and destroyed while the OpenGL context is current. Movable, not copyable.
class Texture {
public:
    Texture() = default;
    Texture(Texture&& other) noexcept;
    Texture& operator=(Texture&& other) noexcept;
    ~Texture();

    /// Sets the pixels, row by row from the top: width × height of them.
    void fill(int width, int height, std::span<const Rgba> pixels);

    bool empty() const { return width_ == 0; }
    int width() const { return width_; }
    int height() const { return height_; }

    /// Returns the id that ImGui::Image and ImDrawList::AddImage take.
    ImTextureID id() const;

private:
    unsigned name_ = 0;
    int width_ = 0, height_ = 0;
};

}  // namespace glassbox
