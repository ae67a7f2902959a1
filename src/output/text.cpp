#include "output/text.hpp"

#include <algorithm>
#include <cmath>

#include "output/font.hpp"
#include "scene/utf8.hpp"

#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb_truetype.h>

namespace glassbox {
namespace {

struct Font {
    stbtt_fontinfo info{};
    float scale;     // pixels per font unit
    float baseline;  // pixels below the line's top

    explicit Font(int size) {
        stbtt_InitFont(&info, font_file().data(), 0);
        scale = stbtt_ScaleForPixelHeight(&info, static_cast<float>(size));
        int ascent = 0, descent = 0, gap = 0;
        stbtt_GetFontVMetrics(&info, &ascent, &descent, &gap);
        baseline = std::round(static_cast<float>(ascent) * scale);
    }

    float advance(char32_t character, char32_t next) const {
        int width = 0, bearing = 0;
        stbtt_GetCodepointHMetrics(&info, static_cast<int>(character), &width, &bearing);
        const int kern =
            next ? stbtt_GetCodepointKernAdvance(&info, static_cast<int>(character), static_cast<int>(next)) : 0;
        return scale * static_cast<float>(width + kern);
    }
};

std::u32string characters(std::string_view text) {
    std::u32string all;
    while (!text.empty()) {
        const auto [code, size] = first_character(text);
        all += code.value_or(U'\uFFFD');
        text.remove_prefix(size);
    }
    return all;
}

std::uint8_t mixed(std::uint8_t under, std::uint8_t over, int coverage) {
    return static_cast<std::uint8_t>((under * (255 - coverage) + over * coverage + 127) / 255);
}

void draw_character(Image& image, const Font& font, char32_t character, float x, int y, Rgb color) {
    const float whole = std::floor(x);
    int left = 0, top = 0, right = 0, bottom = 0;
    const int code = static_cast<int>(character);
    stbtt_GetCodepointBitmapBoxSubpixel(&font.info, code, font.scale, font.scale, x - whole, 0, &left, &top, &right,
                                        &bottom);
    const int width = right - left, height = bottom - top;
    if (width <= 0 || height <= 0) return;
    std::vector<unsigned char> coverage(pixel_count(width, height));
    stbtt_MakeCodepointBitmapSubpixel(&font.info, coverage.data(), width, height, width, font.scale, font.scale,
                                      x - whole, 0, code);

    const int corner_x = static_cast<int>(whole) + left;
    const int corner_y = y + static_cast<int>(font.baseline) + top;
    for (int row = std::max(0, -corner_y); row < std::min(height, image.height - corner_y); ++row)
        for (int column = std::max(0, -corner_x); column < std::min(width, image.width - corner_x); ++column) {
            const int amount = coverage[index_of({column, row}, width)];
            Rgb& pixel = image.at(corner_x + column, corner_y + row);
            pixel = {mixed(pixel.red, color.red, amount), mixed(pixel.green, color.green, amount),
                     mixed(pixel.blue, color.blue, amount)};
        }
}

float width_of(const Font& font, std::string_view text) {
    const std::u32string all = characters(text);
    float width = 0;
    for (std::size_t i = 0; i < all.size(); ++i) width += font.advance(all[i], i + 1 < all.size() ? all[i + 1] : 0);
    return width;
}

}  // namespace

int text_width(std::string_view text, int size) { return static_cast<int>(std::ceil(width_of(Font(size), text))); }

void draw_text(Image& image, int x, int y, std::string_view text, const TextStyle& style) {
    const Font font(style.size);
    const std::u32string all = characters(text);
    float pen = static_cast<float>(x);
    for (std::size_t i = 0; i < all.size(); ++i) {
        draw_character(image, font, all[i], pen, y, style.color);
        pen += font.advance(all[i], i + 1 < all.size() ? all[i + 1] : 0);
    }
}

std::vector<std::string> wrapped(std::string_view text, int size, int width) {
    const Font font(size);
    const auto fits = [&](std::string_view line) { return width_of(font, line) <= static_cast<float>(width); };
    std::vector<std::string> lines;
    std::string line;
    const auto end_line = [&] {
        if (!line.empty()) lines.push_back(std::move(line));
        line.clear();
    };
    while (!text.empty()) {
        const std::size_t space = text.find(' ');
        std::string_view word = text.substr(0, space);
        text.remove_prefix(space == std::string_view::npos ? text.size() : space + 1);
        if (word.empty()) continue;
        const std::string joined = line.empty() ? std::string(word) : line + " " + std::string(word);
        if (fits(joined)) {
            line = joined;
            continue;
        }
        end_line();
        for (; !fits(word) && !word.empty(); end_line()) do {  // at least one character per line, however narrow
                const std::size_t length = first_character(word).size;
                line += word.substr(0, length);
                word.remove_prefix(length);
            } while (!word.empty() && fits(line + std::string(word.substr(0, first_character(word).size))));
        line = word;
    }
    end_line();
    return lines;
}

}  // namespace glassbox
