#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "render/image.hpp"

namespace glassbox {

/// A text's style: its line height in pixels (that of DejaVu Sans), and its colour.
struct TextStyle {
    int size = 18;
    Rgb color = {};
};

/// The width of a line of UTF-8 text in pixels. A byte that is not UTF-8 counts as the replacement character.
int text_width(std::string_view text, int size);

/// Draws a line of UTF-8 text, antialiased and clipped to the picture; (x, y) is its top left corner.
void draw_text(Image& image, int x, int y, std::string_view text, const TextStyle& style);

/// Breaks the text into lines at most `width` pixels wide, between words; breaks a longer word between characters.
std::vector<std::string> wrapped(std::string_view text, int size, int width);

}  // namespace glassbox
