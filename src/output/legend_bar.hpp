#pragma once
#include <functional>
#include <string>
#include <vector>

#include "output/coloring.hpp"

namespace glassbox {

// The bar of a legend: the colours of the scale from its low to its high, in any number of columns. The caller draws
// it.

/// The column of a value; for blocks, the middle of its block.
int place_on_bar(const Coloring& coloring, double value, int width);

/// The colour of a column.
Rgb color_on_bar(const Coloring& coloring, int column, int width);

/// A tick's column, and the first column of its label.
struct PlacedTick {
    int mark, left;
    std::string label;
};

/// As many ticks as fit without overlapping labels, each label under its mark as far as the bar's ends allow. `size` is
/// the text's height, `text_width` measures a label.
std::vector<PlacedTick> placed_ticks(const Coloring& coloring, int width, int size,
                                     const std::function<int(const std::string&)>& text_width);

}  // namespace glassbox
