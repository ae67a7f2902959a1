#include <fmt/format.h>

#include <algorithm>

#include "compare/pictures_report.hpp"
#include "output/column.hpp"
#include "output/sheet.hpp"
#include "scene/suggestion.hpp"

namespace glassbox {

namespace {

/// Bright on a dark picture, and of different lightness: blue, pink, orange, and nearly white.
constexpr Rgb rounding_color{70, 150, 255}, unknown_color{255, 110, 220}, mistake_color{255, 150, 0},
    tie_color{90, 200, 110}, not_looked_into{240, 240, 200};

Rgb color_of(Cause cause) {
    if (cause == Cause::tie) return tie_color;
    return cause == Cause::mistake ? mistake_color : cause == Cause::unknown ? unknown_color : rounding_color;
}

/// A quarter as bright, and without colour.
Rgb dimmed(const Rgb& color) {
    const auto grey = static_cast<std::uint8_t>((color.red + 2 * color.green + color.blue) / 16);
    return {grey, grey, grey};
}

/// A square of at least three pixels a side about that pixel of the picture before it was enlarged.
void mark(Image& image, Pixel pixel, int factor, Rgb color) {
    constexpr int least = 3;
    const int side = std::max(factor, least), beyond = (side - factor) / 2;
    fill(image, pixel.x * factor - beyond, pixel.y * factor - beyond, side, side, color);
}

}  // namespace

Image difference_picture(const PictureComparison& comparison, const Image& theirs) {
    const Image& ours = comparison.ours;
    Image small = ours;
    for (std::size_t i = 0; i < small.pixels.size(); ++i)
        small.pixels[i] = theirs.pixels[i] == ours.pixels[i] ? dimmed(ours.pixels[i]) : not_looked_into;
    const int factor = enlargement(ours.width, ours.height);
    Image picture = enlarged(small, factor);
    for (const Cause cause : {Cause::tie, Cause::rounding, Cause::unknown, Cause::mistake})  // the worst on top
        for (const PixelDifference& one : comparison.looked_into)
            if (one.cause == cause) mark(picture, one.pixel, factor, color_of(cause));

    const int size = std::max(14, picture.height / 24), margin = size;
    const int width = std::max(picture.width, 20 * size);
    Column legend(width, size);
    legend.paragraph(fmt::format("differ: {} of {}", comparison.differ, counted(ours.pixels.size(), "pixel")),
                     {size, ink});
    for (const Cause cause : {Cause::mistake, Cause::unknown, Cause::rounding, Cause::tie})
        legend.swatch(color_of(cause), fmt::format("{}: {}", causes[static_cast<std::size_t>(cause)].help,
                                                   counted(comparison.count(cause), "pixel")));
    if (!comparison.is_all())
        legend.swatch(not_looked_into,
                      fmt::format("they differ, too, and were not looked into: {}",
                                  counted(comparison.differ - comparison.looked_into.size(), "pixel")));
    legend.swatch({24, 24, 24}, "the same: our picture, dark and grey");

    Image sheet(width + 2 * margin, picture.height + legend.image.height + 3 * margin, paper);
    paste(sheet, picture, margin, margin);
    paste(sheet, legend.image, margin, picture.height + 2 * margin);
    return sheet;
}

}  // namespace glassbox
