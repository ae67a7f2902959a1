#pragma once
#include <functional>
#include <string>

#include "compare/compare_pictures.hpp"

namespace glassbox {

/// What is to be told of a comparison of pictures.
struct PicturesReport {
    const PictureComparison& comparison;
    Theirs theirs;
    std::size_t worst = 5;                      ///< how many differences to tell
    std::function<std::string(Pixel)> command;  ///< that explains a pixel
    /// How many rounding would not explain in float either, where that was asked, too.
    std::optional<std::size_t> beyond_float = {};
};

/// For a reader: how many differ, how many of these rounding explains; then the worst, and the first.
std::string to_text(const PicturesReport& report);

/// For a program: docs/compare.md has the fields.
std::string to_json(const PicturesReport& report);

/// Our picture, dark, with all pixels that differ in bright colours by their cause, and what these mean below it.
Image difference_picture(const PictureComparison& comparison, const Image& theirs);

}  // namespace glassbox
