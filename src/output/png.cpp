#include "output/png.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <string>

#include "scene/error.hpp"

#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

namespace glassbox {

static_assert(sizeof(Rgb) == 3, "a row of pixels is handed over as bytes");

namespace {

void append_number(std::string& bytes, std::uint32_t number) {
    for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(number >> shift & 255);
}

/// A chunk of text after its keyword: tEXt, which every program reads; with letters that are not ASCII iTXt, in UTF-8,
/// neither compressed nor in a language.
std::string text_chunk(const std::string& keyword, const std::string& text) {
    const bool ascii =
        std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 128; });
    std::string typed = (ascii ? "tEXt" : "iTXt") + keyword + std::string(ascii ? 1 : 5, '\0') + text;
    std::string chunk;
    append_number(chunk, static_cast<std::uint32_t>(typed.size() - 4));
    chunk += typed;
    append_number(chunk, stbiw__crc32(reinterpret_cast<unsigned char*>(typed.data()), static_cast<int>(typed.size())));
    return chunk;
}

}  // namespace

std::vector<std::byte> png(const Image& image, const Origin& origin) {
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
    std::string texts;
    for (const auto& [keyword, text] : notes_of(origin)) texts += text_chunk(keyword, text);
    constexpr std::ptrdiff_t after_header = 8 + 4 + 4 + 13 + 4;  // the signature, and the chunk IHDR
    const auto inserted = std::as_bytes(std::span(texts));
    bytes.insert(bytes.begin() + after_header, inserted.begin(), inserted.end());
    return bytes;
}

}  // namespace glassbox
