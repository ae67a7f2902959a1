#pragma once
#include <functional>
#include <string>
#include <vector>

#include "output/coloring.hpp"

namespace glassbox {

// The bar of a legend, whoever draws it: as many columns wide as one likes, the colours of the scale from its low to
// its high.

/// In which column a value stands; for blocks, in the middle of its own.
int place_on_bar(const Coloring& coloring, double value, int width);

/// The colour of a column.
Rgb color_on_bar(const Coloring& coloring, int column, int width);

/// A tick's column, and the first column of its label.
struct PlacedTick {
    int mark, left;
    std::string label;
};

/// The most ticks whose labels keep apart, each under its mark as far as the bar's ends allow. `size` is the text's
/// height, `text_width` measures a label.
std::vector<PlacedTick> placed_ticks(const Coloring& coloring, int width, int size,
                                     const std::function<int(const std::string&)>& text_width);

}  // namespace glassbox
