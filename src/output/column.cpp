#include "output/column.hpp"

#include <algorithm>

namespace glassbox {

void fill(Image& image, int x, int y, int width, int height, Rgb color) {
    for (int row = std::max(0, y); row < std::min(y + height, image.height); ++row)
        for (int column = std::max(0, x); column < std::min(x + width, image.width); ++column)
            image.at(column, row) = color;
}

int Column::grow(int rows) {
    const int top = image.height;
    image.height += rows;
    image.pixels.resize(image.pixels.size() + static_cast<std::size_t>(rows) * static_cast<std::size_t>(image.width),
                        paper);
    return top;
}

void Column::paragraph(std::string_view text, const TextStyle& style, int indent) {
    for (const std::string& words : wrapped(text, style.size, image.width - indent))
        draw_text(image, indent, grow(style.size * 5 / 4), words, style);
}

void Column::swatch(Rgb color, std::string_view text) {
    const int top = grow(0);
    const int side = size;
    paragraph(text, {size, ink}, side + size / 2);
    fill(image, 0, top, side, side, ink);
    fill(image, 1, top + 1, side - 2, side - 2, color);
}

void Column::ends(const std::string& left, const std::string& right, int width) {
    const int right_width = text_width(right, size);
    const bool together = text_width(left, size) + size + right_width <= width;
    const int top = grow(0);
    paragraph(left, {size, ink});
    if (!together && right_width > width) return paragraph(right, {size, ink});
    draw_text(image, width - right_width, together ? top : grow(line()), right, {size, ink});
}

}  // namespace glassbox
