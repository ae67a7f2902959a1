#include "output/heat_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "output/coloring.hpp"
#include "output/legend.hpp"
#include "output/sheet.hpp"

namespace glassbox {
namespace {

/// A measurement's part of the sheet: the title above, the picture, the legend below.
struct Panel {
    Image title, picture, legend;
};

int enlargement(const Channel& channel) { return glassbox::enlargement(channel.width, channel.height); }

/// A text size legible from the back row: about a 24th of the picture's side, and larger on a sheet with many panels,
/// which is shown smaller.
int text_size(const Channel& channel, std::size_t panels) {
    const double side = enlargement(channel) * std::sqrt(static_cast<double>(channel.width) * channel.height);
    return std::max(14, static_cast<int>(side / 24 * std::pow(static_cast<double>(panels), 1.0 / 6)));
}

Panel panel_of(const Measured& measured, std::size_t panels) {
    const Channel& channel = measured.channels.front();
    const int size = text_size(channel, panels);
    Image picture = enlarged(colored(measured), enlargement(channel));
    const int width = std::max(picture.width, 15 * size);
    return {title(*measured.what, width, size).image, std::move(picture), legend(measured, width, size).image};
}

}  // namespace

Image heat_map(std::span<const Measured> measured) {
    std::vector<Panel> panels;
    int width = 0, margin = 14;
    int above = 0, middle = 0, below = 0;  // the greatest heights of the parts of a panel
    for (const Measured& m : measured) {
        panels.push_back(panel_of(m, measured.size()));
        const Panel& panel = panels.back();
        width = std::max(width, panel.title.width);
        above = std::max(above, panel.title.height);
        middle = std::max(middle, panel.picture.height);
        below = std::max(below, panel.legend.height);
        margin = std::max(margin, text_size(m.channels.front(), measured.size()));
    }
    const int gap = margin / 2;  // between the parts of a panel
    const int height = above + gap + middle + gap + below;

    // Chooses the number of columns that makes the sheet nearest to a square, and leaves the fewest places empty.
    const int count = static_cast<int>(panels.size());
    const auto sheet = [&](int columns) {
        const int rows = (count + columns - 1) / columns;
        return std::pair(margin + columns * (width + margin), margin + rows * (height + margin));
    };
    int columns = 1;
    const auto goodness = [&](int c) {
        const auto [w, h] = sheet(c);
        const double used = static_cast<double>(count) / ((count + c - 1) / c * c);
        return used * std::min(w, h) / std::max(w, h);
    };
    for (int c = 2; c <= count; ++c)
        if (goodness(c) > goodness(columns)) columns = c;

    const auto [sheet_width, sheet_height] = sheet(columns);
    Image image(sheet_width, sheet_height, paper);
    for (int i = 0; i < count; ++i) {
        const Panel& panel = panels[static_cast<std::size_t>(i)];
        const int x = margin + i % columns * (width + margin);
        const int y = margin + i / columns * (height + margin);
        paste(image, panel.title, x, y);
        // A frame, for what is as white as the paper.
        fill(image, x - 1, y + above + gap - 1, panel.picture.width + 2, panel.picture.height + 2, soft_ink);
        paste(image, panel.picture, x, y + above + gap);
        paste(image, panel.legend, x, y + above + gap + middle + gap);
    }
    return image;
}

}  // namespace glassbox
