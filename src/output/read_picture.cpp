#include "output/read_picture.hpp"

#include <fmt/core.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <limits>
#include <memory>
#include <vector>

#include "scene/error.hpp"
#include "scene/scene.hpp"
#include "scene/text_file.hpp"

#define STBI_ONLY_PNG
#define STBI_ONLY_PNM
#define STBI_NO_STDIO
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>

namespace glassbox {

namespace {

using Bytes = std::vector<stbi_uc>;

/// Reads piece by piece, and so refuses an endless device, too.
Bytes read_bytes(const std::filesystem::path& file) {
    if (const auto reason = why_unreadable(file)) throw error_at({file.string()}, *reason);
    std::ifstream in(file, std::ios::binary);
    Bytes bytes;
    std::array<char, 1 << 16> piece;
    while (in.read(piece.data(), piece.size()), in.gcount() > 0) {
        bytes.insert(bytes.end(), piece.begin(), piece.begin() + in.gcount());
        if (bytes.size() > std::size_t{std::numeric_limits<int>::max()} / 2)
            throw error_at({file.string()}, "more than 1 GB is too much for a picture here");
    }
    if (in.bad()) throw error_at({file.string()}, "reading stopped halfway");
    return bytes;
}

}  // namespace

Image read_picture(const std::filesystem::path& file) {
    constexpr int with_alpha = 4;
    const Bytes bytes = read_bytes(file);
    const auto size = static_cast<int>(bytes.size());
    int width = 0, height = 0, channels = 0;
    if (!stbi_info_from_memory(bytes.data(), size, &width, &height, &channels))
        throw error_at({file.string()}, "this is neither a PNG nor a binary PPM picture; save it as one of them");
    if (std::int64_t{width} * height > max_pixels)
        throw error_at({file.string()},
                       fmt::format("{}x{} pixels are too many; {} are allowed", width, height, max_pixels));
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, with_alpha), stbi_image_free);
    if (!pixels)
        throw error_at({file.string()}, fmt::format("the picture is broken: {}; save it anew", stbi_failure_reason()));
    Image image(width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const stbi_uc* const pixel = pixels.get() + with_alpha * i;
        if (pixel[3] != 255)
            throw error_at({file.string()},
                           fmt::format("one can see through pixel {},{}; save it without an alpha channel",
                                       i % static_cast<std::size_t>(width), i / static_cast<std::size_t>(width)));
        image.pixels[i] = {pixel[0], pixel[1], pixel[2]};
    }
    return image;
}

}  // namespace glassbox
