#pragma once
#include <string>
#include <string_view>

#include "output/text.hpp"
#include "render/image.hpp"

namespace glassbox {

inline constexpr Rgb paper{255, 255, 255};
inline constexpr Rgb ink{20, 20, 20};
inline constexpr Rgb soft_ink{70, 70, 70};

/// Fills a rectangle, clipped to the picture.
void fill(Image& image, int x, int y, int width, int height, Rgb color);

/// A column of text and swatches that grows downwards; its content is never clipped.
struct Column {
    Image image;
    int size;  ///< the text's, in pixels

    Column(int width, int text_size) : image(width, 0), size(text_size) {}

    /// The distance from one line's top to the next one's.
    int line() const { return size * 5 / 4; }

    /// Adds that many empty pixel rows; returns the first.
    int grow(int rows);

    /// Adds a text, wrapped.
    void paragraph(std::string_view text, const TextStyle& style, int indent = 0);

    /// Adds a square of that colour with its meaning.
    void swatch(Rgb color, std::string_view text);

    /// Adds two texts at the ends of one line, or on separate lines if they do not fit.
    void ends(const std::string& left, const std::string& right, int width);
};

}  // namespace glassbox
