#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "output/legend_bar.hpp"
#include "output/legend_number.hpp"
#include "viewer/ui/overlay/parts.hpp"

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
        return color(std::lerp(of.coloring.low, of.coloring.high, static_cast<double>(column) / (columns() - 1)));
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
    const MeasuredChannels& measured = *frame.results.overlay;
    const Channel& channel = measured.channels[static_cast<std::size_t>(std::max(axis, 0))];
    if (!pixel || measured.factor > 1 || pixel->x >= channel.width || pixel->y >= channel.height) return {};
    return channel.at(*pixel);
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
        values += (i > 0 ? ", " : "") + legend_number(*value, 6);
        if (std::isnan(*value)) {
            values = "no value";
            break;
        }
    }
    if (values != "no value") values = with_unit(values, measured.what->unit);
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextWrapped("pixel %s (%d, %d): %s", name, pixel->x, pixel->y, values.c_str());
    ImGui::PopStyleColor();
}

/// "3 to 5: 12 pixels, 0.1 % of those with a value"
void tell_bin(const Plot& plot, const Measurement& what, std::size_t index) {
    const Bin& bin = plot.histogram().bins[index];
    const int digits = digits_between(bin.from, bin.to);
    std::string text = legend_number(bin.from, digits);
    if (bin.to != bin.from) text += " to " + legend_number(bin.to, digits);
    std::int64_t all = 0;
    for (const Bin& each : plot.histogram().bins) all += each.count;
    const double percent = all > 0 ? 100.0 * static_cast<double>(bin.count) / static_cast<double>(all) : 0;
    ImGui::SetTooltip(
        "%s",
        fmt::format("{}\n{}, {:.2g} % of those here", with_unit(text, what.unit), pixels(bin.count), percent).c_str());
}

/// The range between two positions on the bar.
std::pair<double, double> range_between(const Plot& plot, double one, double other) {
    const double from = std::clamp(std::min(one, other), 0.0, 1.0), to = std::clamp(std::max(one, other), 0.0, 1.0);
    const auto [low, high] = std::pair(plot.of.coloring.low, plot.of.coloring.high);
    if (!plot.histogram().whole) return {std::lerp(low, high, from), std::lerp(low, high, to)};
    const double numbers = high - low + 1;
    const double first = std::min(high, low + std::floor(from * numbers));
    return {first, std::max(first, low + std::ceil(to * numbers) - 1)};
}

void listen(ImDrawList& list, const Plot& plot, const Measurement& what) {
    ImGui::SetCursorScreenPos(plot.corner);
    ImGui::InvisibleButton("plot", {plot.width, plot.height + plot.bar});
    const ImGuiIO& io = ImGui::GetIO();
    const auto place = [&](float x) { return static_cast<double>((x - plot.corner.x) / plot.width); };
    const float clicked = io.MouseClickedPos[ImGuiMouseButton_Left].x, now = io.MousePos.x;
    const bool far = std::abs(now - clicked) >= ImGui::GetFontSize() / 4;
    if (plot.axis < 0 && far && ImGui::IsItemActive())
        list.AddRectFilled({plot.x(std::clamp(place(std::min(clicked, now)), 0., 1.)), plot.corner.y},
                           {plot.x(std::clamp(place(std::max(clicked, now)), 0., 1.)), plot.corner.y + plot.height},
                           (plot.frame.palette.accent & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 80));
    if (plot.axis < 0 && far && ImGui::IsItemDeactivated())
        plot.frame.state.overlay.range = range_between(plot, place(clicked), place(now));
    if (!ImGui::IsItemHovered()) return;
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) plot.frame.state.overlay.range.reset();
    for (std::size_t i = 0; i < plot.histogram().bins.size(); ++i) {
        const auto [from, to] = plot.place(i);
        if (place(now) < from || place(now) >= to) continue;
        list.AddRect({plot.x(from), plot.corner.y}, {plot.x(to), plot.corner.y + plot.height}, plot.frame.palette.text);
        tell_bin(plot, what, i);
    }
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
    draw_bar(list, plot, what);
    draw_ticks(list, plot);
    draw_pins(list, plot);
    ImGui::PushID(axis);
    listen(list, plot, what);
    ImGui::PopID();
    ImGui::SetCursorScreenPos({at.x, plot.corner.y + height + plot.bar + size * 1.4f});
    if (axis >= 0 && axis < 2) return;
    say_pin(frame, frame.state.pinned, frame.palette.accent, "1");
    say_pin(frame, frame.state.compared, frame.palette.second, "2");
    if (!frame.state.pinned) faint(frame, "Click a pixel of the picture: its value is marked here.");
}

}  // namespace glassbox
