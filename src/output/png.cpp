#include "output/png.hpp"

#include <fmt/core.h>

#include <cstdint>
#include <limits>
#include <span>

#include "scene/error.hpp"

#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

namespace glassbox {

static_assert(sizeof(Rgb) == 3, "a row of pixels is handed over as bytes");

std::vector<std::byte> png(const Image& image) {
    if (image.width <= 0 || image.height <= 0)
        throw Error("error: a PNG picture has at least one pixel; this one has none");
    // The encoder counts bytes in int.
    if ((std::int64_t{image.width} * 3 + 1) * image.height > std::numeric_limits<int>::max() / 2)
        throw Error(fmt::format("error: {}x{} pixels are too many for PNG here; write .ppm, or a smaller picture",
                                image.width, image.height));

    std::vector<std::byte> bytes;
    const auto append = [](void* context, void* data, int size) {
        const std::span piece(static_cast<const std::byte*>(data), static_cast<std::size_t>(size));
        auto& all = *static_cast<std::vector<std::byte>*>(context);
        all.insert(all.end(), piece.begin(), piece.end());
    };
    if (!stbi_write_png_to_func(append, &bytes, image.width, image.height, 3, image.pixels.data(), 3 * image.width))
        throw Error("error: there is not enough memory to encode the picture; write .ppm, or a smaller one");
    return bytes;
}

}  // namespace glassbox
