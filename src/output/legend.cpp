#include "output/legend.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "output/coloring.hpp"
#include "output/legend_bar.hpp"
#include "output/legend_number.hpp"
#include "output/value_words.hpp"

namespace glassbox {
namespace {

/// Draws a triangle that points down at the bar.
void draw_pointer(Image& image, int x, int y, int height) {
    for (int row = 0; row < height; ++row) {
        const int half = (height - 1 - row) * 2 / 3;
        fill(image, x - half, y + row, 2 * half + 1, 1, ink);
    }
}

void draw_bar(Column& column, const Coloring& coloring, const Summary& summary) {
    const int size = column.size;
    const int width = std::min(column.image.width, 40 * size);
    if (summary.any_finite()) {
        const int height = size / 2;
        const int top = column.grow(height + 1);
        for (const double v : {summary.least, summary.greatest})
            draw_pointer(column.image,
                         std::clamp(place_on_bar(coloring, std::clamp(v, coloring.low, coloring.high), width),
                                    height * 2 / 3, width - 1 - height * 2 / 3),
                         top, height);
    }
    const int bar = column.grow(size * 5 / 4);
    for (int x = 0; x < width; ++x) fill(column.image, x, bar, 1, size * 5 / 4, color_on_bar(coloring, x, width));
    const std::vector<PlacedTick> labels =
        placed_ticks(coloring, width, size, [&](const std::string& text) { return text_width(text, size); });
    if (labels.empty()) return;
    const int marks = column.grow(size / 3 + column.line());
    const int thickness = std::max(1, size / 10);
    for (const PlacedTick& label : labels) {
        fill(column.image, std::clamp(label.mark - thickness / 2, 0, width - thickness), marks, thickness, size / 3,
             ink);
        draw_text(column.image, label.left, marks + size / 3, label.label, {size, ink});
    }
}

/// "wrong hit: 5 pixels"; a colour that no pixel has is named alone.
void add_swatch(Column& column, const ColorWord& word) {
    column.swatch(word.color, word.pixels == 0 ? word.text : word.text + ": " + pixels(word.pixels));
}

Column scale_legend(const Measured& measured, int width, int size) {
    const Channel& channel = measured.channels.front();
    const Measurement& what = *measured.what;
    const Summary summary = summarized(channel, spacing_of(what, measured.spacing));
    const Coloring coloring = coloring_of(what, summary, {}, measured.spacing);
    const std::string_view unit = what.unit;

    Column column(width, size);
    if (!what.words.empty()) {
        // Each word has a swatch.
    } else if (summary.any_finite()) {
        const int digits = digits_between(summary.least, summary.greatest);
        const std::string least = with_unit(legend_number(summary.least, digits), unit);
        if (summary.least == summary.greatest) column.paragraph("least and greatest " + least, {size, ink});
        else
            column.ends("least " + least, "greatest " + with_unit(legend_number(summary.greatest, digits), unit),
                        std::min(width, 40 * size));
    } else {
        column.paragraph("no pixel has a finite value", {size, ink});
    }
    if (what.words.empty() && (summary.any_finite() || what.range)) draw_bar(column, coloring, summary);
    if (coloring.spacing != Spacing::linear) column.paragraph(spacing_in_words(coloring.spacing), {size, soft_ink});
    column.grow(size / 3);
    for (const ColorWord& word : color_words(what, channel, summary, coloring)) add_swatch(column, word);
    return column;
}

Column direction_legend(const Measured& measured, int width, int size) {
    Column column(width, size);
    const char* names[] = {"x red", "y green", "z blue"};
    const int indent = text_width("y green", size) + size / 2;
    const int bar = std::min(width - indent, 20 * size);
    for (int axis = 0; axis < 3; ++axis) {
        const int top = column.grow(column.line());
        draw_text(column.image, 0, top, names[axis], {size, ink});
        for (int x = 0; x < bar; ++x) {
            const double v = 2.0 * x / (bar - 1) - 1;
            const Rgb color = direction_color(axis == 0 ? v : 0, axis == 1 ? v : 0, axis == 2 ? v : 0);
            fill(column.image, indent + x, top + size / 12, 1, size, color);
        }
    }
    const int top = column.grow(column.line());
    const auto label = [&](const char* text, int share_of_two) {
        const int free = bar - text_width(text, size);
        draw_text(column.image, indent + free * share_of_two / 2, top, text, {size, ink});
    };
    label("−1", 0);
    label("0", 1);
    label("1", 2);

    std::int64_t missing = 0, outside = 0;
    for (std::size_t i = 0; i < measured.channels[0].values.size(); ++i) {
        const double x = measured.channels[0].values[i], y = measured.channels[1].values[i],
                     z = measured.channels[2].values[i];
        if (std::isnan(x) || std::isnan(y) || std::isnan(z)) ++missing;
        else if (std::max({std::abs(x), std::abs(y), std::abs(z)}) > 1) ++outside;
    }
    column.grow(size / 3);
    add_swatch(column, {no_value_color, "no value", missing});
    if (outside > 0)
        column.paragraph(fmt::format("beyond −1 or 1, shown as if there: {}", pixels(outside)), {size, ink});
    return column;
}

}  // namespace

Column title(const Measurement& what, int width, int size) {
    Column column(width, size);
    const std::string name = what.unit.empty() ? std::string(what.name) : fmt::format("{} in {}", what.name, what.unit);
    column.paragraph(name, {size * 4 / 3, ink});
    column.paragraph(what.explanation, {size, soft_ink});
    return column;
}

Column legend(const Measured& measured, int width, int size) {
    return is_direction(measured) ? direction_legend(measured, width, size) : scale_legend(measured, width, size);
}

}  // namespace glassbox
