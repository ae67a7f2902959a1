#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "output/coloring.hpp"

namespace glassbox {

/// A measured value as a reader reads it: "13.2 digits", "wrong hit", "no value", "∞ (exactly 0, and known to be)".
std::string value_in_words(const Measurement& what, double value, int digits = 6);

/// The same with no more than fits into a pixel: "13.2", "wrong hit", "–", "∞".
std::string value_in_short(const Measurement& what, double value);

/// The same in lines of a word each.
std::vector<std::string> value_in_lines(const Measurement& what, double value);

/// A colour with a meaning of its own, and how many pixels have it.
struct ColorWord {
    Rgb color;
    std::string text;
    std::int64_t pixels;
};

/// What is to be said of a picture's colours beside their bar: each word, what lies outside the scale, what is
/// infinite, what has no value. Of those that no pixel has, only no value and words are told.
std::vector<ColorWord> color_words(const Measurement& what, const Channel& channel, const Summary& summary,
                                   const Coloring& coloring);

/// "on a logarithmic scale"; empty for a linear one.
std::string spacing_in_words(Spacing spacing);

}  // namespace glassbox
