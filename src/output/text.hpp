#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "render/image.hpp"

namespace glassbox {

/// How a text is set: its line height in pixels (that of DejaVu Sans), and its colour.
struct TextStyle {
    int size = 18;
    Rgb color = {};
};

/// How many pixels wide a line of UTF-8 text is. A byte that is not UTF-8 counts as the sign for a character unknown.
int text_width(std::string_view text, int size);

/// Draws a line of UTF-8 text, smoothed; (x, y) is its top left corner. What lies outside the picture is cut.
void draw_text(Image& image, int x, int y, std::string_view text, const TextStyle& style);

/// The text in lines at most `width` pixels wide, broken between words; a longer word is broken between characters.
std::vector<std::string> wrapped(std::string_view text, int size, int width);

}  // namespace glassbox
