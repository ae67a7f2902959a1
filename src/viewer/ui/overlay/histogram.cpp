#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "output/legend_bar.hpp"
#include "output/legend_number.hpp"
#include "output/value_words.hpp"
#include "viewer/model/overlay/laid_over.hpp"
#include "viewer/ui/overlay/parts.hpp"
#include "viewer/ui/widgets/buttons.hpp"

namespace glassbox {

namespace {

ImU32 packed(Rgb c) { return IM_COL32(c.red, c.green, c.blue, 255); }

/// One component's values and colours, and where they are drawn on the screen.
struct Plot {
    const Frame& frame;
    const Distribution& of;
    int axis;  // 0 to 2: of a direction
    ImVec2 corner;
    float width, height, bar;  // of the columns; of the bar of colours below

    const Histogram& histogram() const { return of.histogram; }
    int columns() const { return static_cast<int>(width); }

    Rgb color(double value) const {
        if (axis < 0) return of.coloring(value);
        return direction_color(axis == 0 ? value : 0, axis == 1 ? value : 0, axis == 2 ? value : 0);
    }
    Rgb bar_color(int column) const {
        if (axis < 0) return color_on_bar(of.coloring, column, columns());
        return color(of.coloring.value_at(static_cast<double>(column) / (columns() - 1)));
    }
    /// Where a bin begins and ends, from 0 to 1.
    std::pair<double, double> place(std::size_t bin) const {
        const std::vector<Bin>& bins = histogram().bins;
        const double low = bins.front().from, numbers = bins.back().to - low + 1;
        if (histogram().whole) return {(bins[bin].from - low) / numbers, (bins[bin].to + 1 - low) / numbers};
        const auto all = static_cast<double>(bins.size());
        return {static_cast<double>(bin) / all, static_cast<double>(bin + 1) / all};
    }
    float x(double place) const { return corner.x + static_cast<float>(place) * width; }
    /// The height at which so many pixels are drawn.
    float y(double count) const {
        const auto most = static_cast<double>(std::max<std::int64_t>(1, histogram().most));
        const double share = frame.state.overlay_page.log_counts ? std::log1p(count) / std::log1p(most) : count / most;
        return corner.y + height * static_cast<float>(1 - share);
    }
};

/// The counts at which horizontal lines are drawn.
std::vector<Tick> count_ticks(const Frame& frame, std::int64_t most) {
    if (!frame.state.overlay_page.log_counts) return ticks(0, static_cast<double>(most), 3, true);
    std::vector<Tick> all{{0, "0"}};
    const double lines = std::max(1.0, std::ceil(std::log10(static_cast<double>(most)) / 4));  // four of them at most
    for (double power = 0; std::pow(10, power) <= static_cast<double>(most); power += lines)
        all.push_back({std::pow(10, power), legend_number(std::pow(10, power), 1)});
    return all;
}

void draw_counts(ImDrawList& list, const Plot& plot, const std::vector<Tick>& counts) {
    const float size = ImGui::GetFontSize();
    float last = plot.corner.y + plot.height + size * 2;
    for (const Tick& tick : counts) {
        const float y = plot.y(tick.value);
        if (last - y < size) continue;  // no room for its label
        last = y;
        list.AddLine({plot.corner.x, y}, {plot.corner.x + plot.width, y}, plot.frame.palette.line);
        const float width = ImGui::CalcTextSize(tick.label.c_str()).x;
        list.AddText({plot.corner.x - width - size * .3f, y - size / 2}, plot.frame.palette.faint_text,
                     tick.label.c_str());
    }
}

void draw_bins(ImDrawList& list, const Plot& plot) {
    const float floor = plot.corner.y + plot.height;
    for (std::size_t i = 0; i < plot.histogram().bins.size(); ++i) {
        const Bin& bin = plot.histogram().bins[i];
        if (bin.count == 0) continue;
        const auto [from, to] = plot.place(i);
        const float top = std::min(plot.y(static_cast<double>(bin.count)), floor - 2);  // one must be visible
        const float gap = plot.histogram().bins.size() <= 20 ? 1.f : 0.f;
        const double middle = plot.of.coloring.blocks ? bin.from : std::lerp(bin.from, bin.to, .5);
        const ImVec2 left{plot.x(from) + gap, top}, right{std::max(plot.x(to) - gap, plot.x(from) + gap + 1), floor};
        list.AddRectFilled(left, right, packed(plot.color(middle)));
    }
}

/// A frame around a bin, over its whole height.
void frame_bin(ImDrawList& list, const Plot& plot, std::size_t bin, ImU32 color, float thick) {
    const auto [from, to] = plot.place(bin);
    list.AddRect({plot.x(from) - 1, plot.corner.y}, {plot.x(to) + 1, plot.corner.y + plot.height}, color, 0, 0, thick);
}

/// Lights up the bins that are brushed, and those of the pinned pixel and of the one under the mouse.
void draw_lit(ImDrawList& list, const Plot& plot, const std::optional<double>& pinned,
              const std::optional<double>& hovered) {
    const Histogram& histogram = plot.histogram();
    const Brush* const brush = plot.axis < 0 ? brush_of(plot.frame.state.overlay) : nullptr;
    if (brush && !histogram.bins.empty()) {
        const auto from = histogram.bin_of(std::max(brush->from, histogram.bins.front().from));
        const auto to = histogram.bin_of(std::min(brush->to, histogram.bins.back().to));
        if (from && to && *from <= *to) {
            const float left = plot.x(plot.place(*from).first), right = plot.x(plot.place(*to).second);
            const float end = plot.corner.y + plot.height;
            const ImU32 shade = (plot.frame.palette.canvas & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 190);
            list.AddRectFilled(plot.corner, {left, end}, shade);
            list.AddRectFilled({right, plot.corner.y}, {plot.corner.x + plot.width, end}, shade);
            list.AddRect({left, plot.corner.y}, {right, end}, plot.frame.palette.text, 0, 0, 2);
        }
    }
    const auto light = [&](const std::optional<double>& value, ImU32 color) {
        const auto bin = value ? histogram.bin_of(*value) : std::nullopt;
        if (bin) frame_bin(list, plot, *bin, color, 2);
    };
    light(pinned, plot.frame.palette.accent);
    light(hovered, plot.frame.palette.warning);
}

void draw_bar(ImDrawList& list, const Plot& plot, const Measurement& what) {
    const float top = plot.corner.y + plot.height, end = top + plot.bar;
    int from = 0;
    for (int x = 0; x <= plot.columns(); ++x) {
        if (x < plot.columns() && plot.bar_color(x) == plot.bar_color(from)) continue;
        list.AddRectFilled({plot.corner.x + static_cast<float>(from), top},
                           {plot.corner.x + static_cast<float>(x), end}, packed(plot.bar_color(from)));
        from = x;
    }
    list.AddRect({plot.corner.x, top}, {plot.corner.x + plot.width, end}, plot.frame.palette.line);
    const auto [low, high] = std::pair(plot.of.coloring.low, plot.of.coloring.high);
    if (!what.contour || *what.contour < low || *what.contour > high) return;
    const float x = plot.corner.x + static_cast<float>(place_on_bar(plot.of.coloring, *what.contour, plot.columns()));
    list.AddLine({x - 1, top}, {x - 1, end}, IM_COL32_BLACK, 2);
    list.AddLine({x + 1, top}, {x + 1, end}, IM_COL32_WHITE, 2);
}

/// Under each block what its number means, a word a line; nothing where they do not fit.
void draw_words(ImDrawList& list, const Plot& plot, const Measurement& what) {
    const float size = ImGui::GetFontSize(), top = plot.corner.y + plot.height + plot.bar + size / 5;
    const float block = plot.width / static_cast<float>(what.words.size());
    const auto width = [](const std::string& word) { return ImGui::CalcTextSize(word.c_str()).x; };
    for (std::size_t i = 0; i < what.words.size(); ++i)
        for (const std::string& word : value_in_lines(what, static_cast<double>(i)))
            if (width(word) > block) return;
    for (std::size_t i = 0; i < what.words.size(); ++i) {
        const float middle = plot.corner.x + block * (static_cast<float>(i) + .5f);
        float y = top;
        for (const std::string& word : value_in_lines(what, static_cast<double>(i))) {
            list.AddText({middle - width(word) / 2, y}, plot.frame.palette.text, word.c_str());
            y += size;
        }
    }
}

void draw_ticks(ImDrawList& list, const Plot& plot) {
    const auto text_width = [](const std::string& text) {
        return static_cast<int>(std::ceil(ImGui::CalcTextSize(text.c_str()).x));
    };
    const float size = ImGui::GetFontSize(), top = plot.corner.y + plot.height + plot.bar;
    for (const PlacedTick& tick : placed_ticks(plot.of.coloring, plot.columns(), static_cast<int>(size), text_width)) {
        const float x = plot.corner.x + static_cast<float>(tick.mark);
        list.AddLine({x, top}, {x, top + size / 4}, plot.frame.palette.text);
        list.AddText({plot.corner.x + static_cast<float>(tick.left), top + size / 4}, plot.frame.palette.text,
                     tick.label.c_str());
    }
}

/// The value measured at a pixel; none while there is only a coarse picture.
std::optional<double> value_at(const Frame& frame, int axis, const std::optional<Pixel>& pixel) {
    const MeasuredChannels* const measured = wholly_laid_over(frame.state, frame.results);
    if (!pixel || !measured) return {};
    return measured->channels[static_cast<std::size_t>(std::max(axis, 0))].at(*pixel);
}

float x_of(const Plot& plot, double value) {
    const double within = std::clamp(value, plot.of.coloring.low, plot.of.coloring.high);
    return plot.corner.x + static_cast<float>(place_on_bar(plot.of.coloring, within, plot.columns()));
}

/// A vertical line through the plot at x, where a pinned pixel's value is, with the pin's number above, moved by
/// `aside`.
void draw_pin(ImDrawList& list, const Plot& plot, float x, float aside, ImU32 color, const char* name) {
    const float size = ImGui::GetFontSize(), thick = std::max(2.f, size / 9);
    const float end = plot.corner.y + plot.height + plot.bar;
    list.AddLine({x, plot.corner.y}, {x, end}, IM_COL32_BLACK, thick + 2);
    list.AddLine({x, plot.corner.y}, {x, end}, color, thick);
    list.AddText({x + aside - ImGui::CalcTextSize(name).x / 2, plot.corner.y - size}, color, name);
}

/// Draws both pins; the numbers of two that are close stand side by side.
void draw_pins(ImDrawList& list, const Plot& plot) {
    const Frame& frame = plot.frame;
    const auto place = [&](const std::optional<Pixel>& pixel) -> std::optional<float> {
        const auto value = value_at(frame, plot.axis, pixel);
        if (!value || std::isnan(*value)) return {};
        return x_of(plot, *value);
    };
    const auto first = place(frame.state.pinned), second = place(frame.state.compared);
    const float room = ImGui::CalcTextSize("00").x / 2;
    float aside = first && second && std::abs(*first - *second) < room ? room / 2 : 0;
    if (aside > 0 && *second < *first) aside = -aside;
    if (second) draw_pin(list, plot, *second, aside, frame.palette.second, "2");
    if (first) draw_pin(list, plot, *first, -aside, frame.palette.accent, "1");
}

void say_pin(const Frame& frame, const std::optional<Pixel>& pixel, ImU32 color, const char* name) {
    const MeasuredChannels& measured = *frame.results.overlay;
    std::string values;
    for (std::size_t i = 0; i < measured.channels.size(); ++i) {
        const auto value = value_at(frame, static_cast<int>(i), pixel);
        if (!value) return;
        values += (i > 0 ? ", " : "") + value_in_words(*measured.what, *value);
    }
    if (!measured.both.empty()) {
        const double subtracted = measured.both.back().at(*pixel);
        const std::string second = legend_number(subtracted, 17);
        values += fmt::format(" = {} − {}", legend_number(measured.both.front().at(*pixel), 17),
                              subtracted < 0 ? "(" + second + ")" : second);
    }
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextWrapped("pixel %s (%d, %d): %s", name, pixel->x, pixel->y, values.c_str());
    ImGui::PopStyleColor();
}

/// "3 to 5: 12 pixels, 0.1 % of those with a value"
void tell_bin(const Plot& plot, const Measurement& what, std::size_t index) {
    const Bin& bin = plot.histogram().bins[index];
    const int digits = digits_between(bin.from, bin.to);
    std::string text = value_in_words(what, bin.from, digits);
    if (bin.to != bin.from) text = legend_number(bin.from, digits) + " to " + value_in_words(what, bin.to, digits);
    std::int64_t all = 0;
    for (const Bin& each : plot.histogram().bins) all += each.count;
    const double percent = all > 0 ? 100.0 * static_cast<double>(bin.count) / static_cast<double>(all) : 0;
    ImGui::SetTooltip(
        "%s", fmt::format("{}\n{}, {:.2g} % of those here\nClick, or drag over bins, to light up their pixels", text,
                          pixels(bin.count), percent)
                  .c_str());
}

/// The bin at a place from 0 to 1; the first or the last beside them.
std::size_t bin_at(const Plot& plot, double place) {
    const std::size_t count = plot.histogram().bins.size();
    for (std::size_t i = 0; i + 1 < count; ++i)
        if (place < plot.place(i).second) return i;
    return count - 1;
}

/// A press brushes a bin, a drag those from there on; a second press on the same bin takes the brush away.
void brush(const Plot& plot, const Measurement& what, double clicked, double now) {
    Overlay& overlay = plot.frame.state.overlay;
    const std::size_t one = bin_at(plot, clicked), other = bin_at(plot, now);
    const auto [from, to] = values_of(plot.histogram(), std::min(one, other), std::max(one, other));
    const Brush brushed{std::string(what.name), from, to};
    if (ImGui::IsItemActivated() && overlay.brush == brushed) overlay.brush.reset();
    else if (ImGui::IsItemActivated() || (ImGui::IsItemActive() && one != other)) overlay.brush = brushed;
}

void listen(ImDrawList& list, const Plot& plot, const Measurement& what) {
    if (plot.histogram().bins.empty()) return;
    ImGui::SetCursorScreenPos(plot.corner);
    ImGui::InvisibleButton("plot", {plot.width, plot.height + plot.bar});
    const ImGuiIO& io = ImGui::GetIO();
    const auto place = [&](float x) { return static_cast<double>((x - plot.corner.x) / plot.width); };
    const double now = place(io.MousePos.x);
    if (plot.axis < 0 && ImGui::IsItemActive())
        brush(plot, what, place(io.MouseClickedPos[ImGuiMouseButton_Left].x), now);
    if (!ImGui::IsItemHovered()) return;
    const std::size_t bin = bin_at(plot, now);
    frame_bin(list, plot, bin, plot.frame.palette.text, 1);
    tell_bin(plot, what, bin);
}

/// What is brushed, and what can be done with it.
void say_brush(const Frame& frame, const Measurement& what) {
    Overlay& overlay = frame.state.overlay;
    const Brush* const brush = brush_of(overlay);
    if (!brush) return faint(frame, "Click a bin, or drag over several: their pixels light up in the picture.");
    std::string text = value_in_words(what, brush->from);
    if (brush->to != brush->from) text = legend_number(brush->from) + " to " + value_in_words(what, brush->to, 4);
    ImGui::TextWrapped("lit up: %s: %s", text.c_str(), pixels(frame.pictures.brushed()).c_str());
    if (what.words.empty() && brush->from < brush->to && ImGui::Button("Give all colours to these"))
        overlay.range = {brush->from, brush->to};
    if (what.words.empty() && brush->from < brush->to) flow("Light up nothing");
    if (ImGui::Button("Light up nothing")) overlay.brush.reset();
}

/// Linear or logarithmic counts.
void axis_switch(OverlayPage& page) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("pixels:");
    ImGui::SameLine();
    if (ImGui::RadioButton("log", page.log_counts)) page.log_counts = true;
    ImGui::SameLine();
    if (ImGui::RadioButton("linear", !page.log_counts)) page.log_counts = false;
}

}  // namespace

void draw_histogram(const Frame& frame, int axis) {
    constexpr const char* names[] = {"x red", "y green", "z blue"};
    const Measurement& what = *frame.results.overlay->what;
    const Distribution& of = frame.pictures.distributions()[static_cast<std::size_t>(std::max(axis, 0))];
    const float size = ImGui::GetFontSize();
    if (axis <= 0) axis_switch(frame.state.overlay_page);
    if (axis >= 0) ImGui::TextUnformatted(names[axis]);

    const std::vector<Tick> counts = count_ticks(frame, of.histogram.most);
    float gutter = 0;
    for (const Tick& tick : counts) gutter = std::max(gutter, ImGui::CalcTextSize(tick.label.c_str()).x);
    gutter = std::ceil(gutter + size * .4f);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = std::floor(ImGui::GetContentRegionAvail().x - gutter - size * .2f);
    if (width < 2 * size) return;
    const float height = std::floor((axis < 0 ? 4.5f : 2.5f) * size);
    const float pins = frame.state.pinned || frame.state.compared ? size : size / 2;
    const Plot plot{frame, of, axis, {at.x + gutter, at.y + pins}, width, height, std::floor(size)};

    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(plot.corner, {plot.corner.x + width, plot.corner.y + height}, frame.palette.canvas);
    draw_counts(list, plot, counts);
    draw_bins(list, plot);
    draw_lit(list, plot, value_at(frame, axis, frame.state.pinned), value_at(frame, axis, frame.state.hovered));
    draw_bar(list, plot, what);
    if (what.words.empty()) draw_ticks(list, plot);
    else draw_words(list, plot, what);
    draw_pins(list, plot);
    ImGui::PushID(axis);
    listen(list, plot, what);
    ImGui::PopID();
    const float below = what.words.empty() ? 1.4f : 2.4f;  // lines of text
    ImGui::SetCursorScreenPos({at.x, plot.corner.y + height + plot.bar + size * below});
    if (axis < 0 && !of.histogram.bins.empty()) say_brush(frame, what);
    if (axis >= 0 && axis < 2) return;
    say_pin(frame, frame.state.pinned, frame.palette.accent, "1");
    say_pin(frame, frame.state.compared, frame.palette.second, "2");
    if (!frame.state.pinned) faint(frame, "Click a pixel of the picture: its value is marked here.");
}

}  // namespace glassbox
