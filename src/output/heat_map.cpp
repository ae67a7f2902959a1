#include "output/heat_map.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "output/color_map.hpp"
#include "output/legend_number.hpp"
#include "output/text.hpp"

namespace glassbox {
namespace {

constexpr Rgb paper{255, 255, 255};
constexpr Rgb ink{20, 20, 20};
constexpr Rgb soft_ink{70, 70, 70};

/// What a legend says about a plane's values. NaN counts as missing.
struct Summary {
    std::int64_t missing = 0, negative_infinite = 0, positive_infinite = 0;
    double least = INFINITY, greatest = -INFINITY;  // of the finite values
    bool whole = true;                              // all finite values are whole numbers

    bool any_finite() const { return least <= greatest; }
};

Summary summarized(const Plane& plane) {
    Summary all;
    for (const double v : plane.values) {
        if (std::isnan(v)) ++all.missing;
        else if (std::isinf(v)) ++(v > 0 ? all.positive_infinite : all.negative_infinite);
        else {
            all.least = std::min(all.least, v);
            all.greatest = std::max(all.greatest, v);
            all.whole = all.whole && v == std::floor(v);
        }
    }
    return all;
}

/// Which value gets which colour.
struct Coloring {
    ColorMap map;
    double low, high;
    bool blocks;  // whole numbers, few: the bar is a row of blocks, one a number

    /// Of a value between the ends: 0 to 1. Scaled to about 1 first, as 1e308 - -1e308 is too large, and halves of
    /// 5e-324 vanish.
    double position(double v) const {
        if (v < low) return 0;
        if (v > high) return 1;
        if (low == high) return 0.5;
        const int e = -std::max(std::ilogb(low), std::ilogb(high)) - 1;
        const double from = std::ldexp(low, e);
        return (std::ldexp(v, e) - from) / (std::ldexp(high, e) - from);
    }

    Rgb operator()(double v) const { return std::isnan(v) ? no_value_color : map(position(v)); }
};

Coloring coloring_of(const Measurement& what, const Summary& summary) {
    double low = summary.any_finite() ? summary.least : 0;
    double high = summary.any_finite() ? summary.greatest : 0;
    if (what.range) std::tie(low, high) = *what.range;
    const bool diverging = what.scale == Scale::diverging;
    if (diverging) {
        high = std::max(std::abs(low), std::abs(high));
        low = -high;
    }
    const bool blocks = !what.range && summary.any_finite() && summary.whole && high - low < 20;
    return {diverging ? diverging_colors() : sequential_colors(), low, high, blocks};
}

bool is_direction(const Measured& m) { return m.what->scale == Scale::direction && m.planes.size() == 3; }

// ---- Drawing

void fill(Image& image, int x, int y, int width, int height, Rgb color) {
    for (int row = std::max(0, y); row < std::min(y + height, image.height); ++row)
        for (int column = std::max(0, x); column < std::min(x + width, image.width); ++column)
            image.at(column, row) = color;
}

void paste(Image& onto, const Image& picture, int x, int y) {
    for (int row = 0; row < picture.height; ++row)
        std::copy_n(&picture.at(0, row), picture.width, &onto.at(x, y + row));
}

Image enlarged(const Image& image, int factor) {
    Image large(image.width * factor, image.height * factor);
    for (int y = 0; y < large.height; ++y)
        for (int x = 0; x < large.width; ++x) large.at(x, y) = image.at(x / factor, y / factor);
    return large;
}

/// A column of text, bars and swatches that grows downwards.
struct Column {
    Image image;
    int size;  // of its text

    Column(int width, int text_size) : image(width, 0), size(text_size) {}

    int line() const { return size * 5 / 4; }

    /// Adds that many empty rows; returns the first.
    int grow(int rows) {
        const int top = image.height;
        image.height += rows;
        image.pixels.resize(
            image.pixels.size() + static_cast<std::size_t>(rows) * static_cast<std::size_t>(image.width), paper);
        return top;
    }

    void paragraph(std::string_view text, const TextStyle& style, int indent = 0) {
        for (const std::string& words : wrapped(text, style.size, image.width - indent))
            draw_text(image, indent, grow(style.size * 5 / 4), words, style);
    }

    void swatch(Rgb color, std::string_view text) {
        const int top = grow(0);
        const int side = size;
        paragraph(text, {size, ink}, side + size / 2);
        fill(image, 0, top, side, side, ink);
        fill(image, 1, top + 1, side - 2, side - 2, color);
    }

    /// Two texts on one line, at its ends, or on lines of their own if they do not fit.
    void ends(const std::string& left, const std::string& right, int width) {
        const int right_width = text_width(right, size);
        const bool together = text_width(left, size) + size + right_width <= width;
        const int top = grow(0);
        paragraph(left, {size, ink});
        if (!together && right_width > width) return paragraph(right, {size, ink});
        draw_text(image, width - right_width, together ? top : grow(line()), right, {size, ink});
    }
};

/// Where on a bar of that width a value stands.
int place_on_bar(const Coloring& coloring, double value, int width) {
    double position = coloring.position(value);
    if (coloring.blocks) position = (value - coloring.low + 0.5) / (coloring.high - coloring.low + 1);
    return static_cast<int>(std::lround(position * (width - 1)));
}

/// The bar's colour in that column.
Rgb color_on_bar(const Coloring& coloring, int column, int width) {
    if (!coloring.blocks)
        return coloring.map(coloring.low == coloring.high ? 0.5 : static_cast<double>(column) / (width - 1));
    const double numbers = coloring.high - coloring.low + 1;
    return coloring(coloring.low + std::floor(column * numbers / width));
}

struct PlacedLabel {
    int mark, left;
    std::string text;
};

/// The most ticks whose labels keep apart, each under its mark as far as the bar's ends allow.
std::vector<PlacedLabel> placed_ticks(const Coloring& coloring, int width, int size) {
    if (coloring.low == coloring.high) {
        const std::string text = legend_number(coloring.low, 6);
        const int half = text_width(text, size) / 2;
        return {{width / 2, std::max(0, width / 2 - half), text}};
    }
    for (int most = std::max(2, width / (3 * size)); most >= 1; --most) {
        std::vector<PlacedLabel> labels;
        bool apart = true;
        int end_of_last = -size;
        for (const Tick& tick : ticks(coloring.low, coloring.high, most, coloring.blocks)) {
            const int mark = place_on_bar(coloring, tick.value, width);
            const int label_width = text_width(tick.label, size);
            const int left = std::clamp(mark - label_width / 2, 0, std::max(0, width - label_width));
            apart = apart && left >= end_of_last + size / 2 && label_width <= width;
            end_of_last = left + label_width;
            labels.push_back({mark, left, tick.label});
        }
        if (apart) return labels;
    }
    return {};
}

/// A triangle that points down at the bar.
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
    const std::vector<PlacedLabel> labels = placed_ticks(coloring, width, size);
    if (labels.empty()) return;
    const int marks = column.grow(size / 3 + column.line());
    const int thickness = std::max(1, size / 10);
    for (const PlacedLabel& label : labels) {
        fill(column.image, std::clamp(label.mark - thickness / 2, 0, width - thickness), marks, thickness, size / 3,
             ink);
        draw_text(column.image, label.left, marks + size / 3, label.text, {size, ink});
    }
}

std::string pixels(std::int64_t count) { return count == 1 ? "1 pixel" : fmt::format("{} pixels", count); }

void add_no_value(Column& column, std::int64_t missing) {
    column.grow(column.size / 3);
    column.swatch(no_value_color, missing == 0 ? "no value" : "no value: " + pixels(missing));
}

std::string with_unit(const std::string& number, std::string_view unit) {
    return unit.empty() || unit == "1" ? number : fmt::format("{} {}", number, unit);
}

Column scale_legend(const Measured& measured, int width, int size) {
    const Plane& plane = measured.planes.front();
    const Summary summary = summarized(plane);
    const Coloring coloring = coloring_of(*measured.what, summary);
    const std::string_view unit = measured.what->unit;

    Column column(width, size);
    if (summary.any_finite()) {
        const int digits = digits_between(summary.least, summary.greatest);
        const std::string least = with_unit(legend_number(summary.least, digits), unit);
        if (summary.least == summary.greatest) column.paragraph("least and greatest " + least, {size, ink});
        else
            column.ends("least " + least, "greatest " + with_unit(legend_number(summary.greatest, digits), unit),
                        std::min(width, 40 * size));
    } else {
        column.paragraph("no pixel has a finite value", {size, ink});
    }
    if (summary.any_finite() || measured.what->range) draw_bar(column, coloring, summary);
    add_no_value(column, summary.missing);

    const auto count = [&](auto&& wanted) { return std::count_if(plane.values.begin(), plane.values.end(), wanted); };
    const auto below = count([&](double v) { return v < coloring.low; }) - summary.negative_infinite;
    const auto above = count([&](double v) { return v > coloring.high; }) - summary.positive_infinite;
    const auto add = [&](std::int64_t number, Rgb color, const std::string& what) {
        if (number > 0) column.swatch(color, what + ": " + pixels(number));
    };
    add(below, coloring.map(0), "below " + legend_number(coloring.low));
    add(above, coloring.map(1), "above " + legend_number(coloring.high));
    add(summary.negative_infinite, coloring.map(0), "−∞");
    add(summary.positive_infinite, coloring.map(1), "∞");
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
    for (std::size_t i = 0; i < measured.planes[0].values.size(); ++i) {
        const double x = measured.planes[0].values[i], y = measured.planes[1].values[i],
                     z = measured.planes[2].values[i];
        if (std::isnan(x) || std::isnan(y) || std::isnan(z)) ++missing;
        else if (std::max({std::abs(x), std::abs(y), std::abs(z)}) > 1) ++outside;
    }
    add_no_value(column, missing);
    if (outside > 0)
        column.paragraph(fmt::format("beyond −1 or 1, shown as if there: {}", pixels(outside)), {size, ink});
    return column;
}

Column title_of(const Measurement& what, int width, int size) {
    Column column(width, size);
    const std::string name =
        what.unit.empty() || what.unit == "1" ? std::string(what.name) : fmt::format("{} in {}", what.name, what.unit);
    column.paragraph(name, {size * 4 / 3, ink});
    column.paragraph(what.explanation, {size, soft_ink});
    return column;
}

/// A measurement's part of the sheet: above, the picture, below.
struct Panel {
    Image title, picture, legend;
};

/// How large a plane of that size is drawn: small ones in whole multiples, so that a pixel stays a square.
int enlargement(const Plane& plane) {
    const int longer = std::max({plane.width, plane.height, 1});
    return longer < 200 ? (200 + longer - 1) / longer : 1;
}

/// Legible from the back row: about a 24th of the picture's side, and larger on a sheet of many, which is shown
/// smaller.
int text_size(const Plane& plane, std::size_t panels) {
    const double side = enlargement(plane) * std::sqrt(static_cast<double>(plane.width) * plane.height);
    return std::max(14, static_cast<int>(side / 24 * std::pow(static_cast<double>(panels), 1.0 / 6)));
}

Panel panel_of(const Measured& measured, std::size_t panels) {
    const Plane& plane = measured.planes.front();
    const int size = text_size(plane, panels);
    Image picture = enlarged(colored(measured), enlargement(plane));
    const int width = std::max(picture.width, 15 * size);
    return {
        title_of(*measured.what, width, size).image, std::move(picture),
        (is_direction(measured) ? direction_legend(measured, width, size) : scale_legend(measured, width, size)).image};
}

}  // namespace

Image colored(const Measured& measured) {
    const Plane& first = measured.planes.front();
    Image image(first.width, first.height, no_value_color);
    if (is_direction(measured)) {
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            const double x = first.values[i], y = measured.planes[1].values[i], z = measured.planes[2].values[i];
            if (!std::isnan(x) && !std::isnan(y) && !std::isnan(z)) image.pixels[i] = direction_color(x, y, z);
        }
    } else {
        const Coloring coloring = coloring_of(*measured.what, summarized(first));
        std::transform(first.values.begin(), first.values.end(), image.pixels.begin(), coloring);
    }
    return image;
}

Image heat_map(std::span<const Measured> measured) {
    std::vector<Panel> panels;
    int width = 0, title = 0, picture = 0, legend = 0, margin = 14;
    for (const Measured& m : measured) {
        panels.push_back(panel_of(m, measured.size()));
        const Panel& panel = panels.back();
        width = std::max(width, panel.title.width);
        title = std::max(title, panel.title.height);
        picture = std::max(picture, panel.picture.height);
        legend = std::max(legend, panel.legend.height);
        margin = std::max(margin, text_size(m.planes.front(), measured.size()));
    }
    const int gap = margin / 2;  // between the parts of a panel
    const int height = title + gap + picture + gap + legend;

    // The number of columns that makes the sheet nearest to a square, and leaves the fewest places empty.
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
        paste(image, panel.picture, x, y + title + gap);
        paste(image, panel.legend, x, y + title + gap + picture + gap);
    }
    return image;
}

}  // namespace glassbox
