#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "output/value_words.hpp"
#include "viewer/model/overlay/laid_over.hpp"
#include "viewer/model/overlay/subtracted.hpp"
#include "viewer/ui/mine/mine.hpp"
#include "viewer/ui/overlay/beside.hpp"
#include "viewer/ui/panels.hpp"
#include "viewer/ui/picture/picture_legend.hpp"
#include "viewer/ui/steps/watch.hpp"

namespace glassbox {

namespace {

constexpr ImU32 lit = IM_COL32(255, 205, 60, 255);  // on any picture, in both themes
constexpr double grid_from = 8, numbers_from = 48;  // zooms

/// Where the picture area lies on the screen, and what is drawn there.
struct Canvas {
    const Frame& frame;
    ImDrawList& list;
    ImVec2 corner, size;  // of the area

    ImVec2 at(double x, double y) const {
        const Point p = frame.state.view.on_screen({x, y});
        return {corner.x + static_cast<float>(p.x), corner.y + static_cast<float>(p.y)};
    }
    /// The visible pixels: from `first` to `last`, both included.
    Pixel first() const { return clamped(frame.state.view.pixel_at({0, 0})); }
    Pixel last() const { return clamped(frame.state.view.pixel_at({size.x, size.y})); }
    Pixel clamped(Pixel p) const {
        return {std::clamp(p.x, 0, frame.state.scene->width - 1), std::clamp(p.y, 0, frame.state.scene->height - 1)};
    }
    float split() const { return corner.x + static_cast<float>(frame.state.split) * size.x; }
};

/// Pictures are drawn between whole pixels of the screen: otherwise a reduced one can lose its last column.
ImVec2 whole(ImVec2 p) { return {std::round(p.x), std::round(p.y)}; }

void draw_texture(const Canvas& canvas, const Texture& texture, ImU32 tint = IM_COL32_WHITE) {
    if (texture.empty()) return;
    const Scene& scene = *canvas.frame.state.scene;
    canvas.list.AddImage(texture.id(), whole(canvas.at(0, 0)), whole(canvas.at(scene.width, scene.height)), {0, 0},
                         {1, 1}, tint);
}

/// Draws nothing, so that our picture is not mistaken for the learner's.
void draw_blank(const Canvas& canvas) {
    const Scene& scene = *canvas.frame.state.scene;
    canvas.list.AddRectFilled(whole(canvas.at(0, 0)), whole(canvas.at(scene.width, scene.height)),
                              canvas.frame.palette.canvas);
}

/// Draws what is right of the split, or over all of the picture.
void draw_layers(const Canvas& canvas) {
    const ViewerState& state = canvas.frame.state;
    const Pictures& pictures = canvas.frame.pictures;
    const Results& results = canvas.frame.results;
    draw_texture(canvas, pictures.picture());
    const bool is_split = state.beside != Beside::nothing;
    const float from = is_split ? canvas.split() : canvas.corner.x;
    canvas.list.PushClipRect({from, canvas.corner.y},
                             {canvas.corner.x + canvas.size.x, canvas.corner.y + canvas.size.y}, true);
    // Dims a picture of outdated code: a new one will come, or cannot.
    const ImU32 tint = mine_is_old(canvas.frame) ? IM_COL32(110, 110, 110, 255) : IM_COL32_WHITE;
    const bool other = state.beside == Beside::other || state.beside == Beside::mine;
    const bool difference = state.beside == Beside::difference || state.beside == Beside::mine_difference;
    if (shows_mine(state)) draw_blank(canvas);
    if (other && results.other.image) draw_texture(canvas, pictures.other(), tint);
    if (difference && results.other.image) draw_texture(canvas, pictures.difference(), tint);
    if (state.beside == Beside::nothing || state.beside == Beside::overlay) {
        const auto alpha = static_cast<int>(std::lround(255 * std::clamp(state.overlay.opacity, 0.0, 1.0)));
        if (last_laid_over(state, results)) draw_texture(canvas, pictures.overlay(), IM_COL32(255, 255, 255, alpha));
    }
    canvas.list.PopClipRect();
}

/// Whether what is seen has fewer pixels so far than it will have.
bool is_coarse(const Frame& frame) {
    const MeasuredChannels* const overlay = laid_over(frame.state, frame.results);
    return frame.results.picture.factor > 1 || (overlay && overlay->factor > 1);
}

void draw_grid(const Canvas& canvas) {
    if (canvas.frame.state.view.zoom < grid_from || is_coarse(canvas.frame)) return;
    const Pixel first = canvas.first(), last = canvas.last();
    constexpr ImU32 faint = IM_COL32(128, 128, 128, 90);
    for (int x = first.x; x <= last.x + 1; ++x)
        canvas.list.AddLine(canvas.at(x, first.y), canvas.at(x, last.y + 1), faint);
    for (int y = first.y; y <= last.y + 1; ++y)
        canvas.list.AddLine(canvas.at(first.x, y), canvas.at(last.x + 1, y), faint);
}

/// The lines of text in a pixel: its red, green and blue, or what is measured there, which is nothing until it is.
std::vector<std::string> numbers_in(const Canvas& canvas, int x, int y, bool overlaid) {
    const Results& results = canvas.frame.results;
    std::vector<std::string> lines;
    if (overlaid) {
        if (const MeasuredChannels* const measured = wholly_laid_over(canvas.frame.state, results))
            for (const Channel& plane : measured->channels)
                for (std::string& line : value_in_lines(*measured->what, plane.at({x, y})))
                    lines.push_back(std::move(line));
        return lines;
    }
    const Rgb c = results.picture.image->at(x, y);
    return {std::to_string(c.red), std::to_string(c.green), std::to_string(c.blue)};
}

/// Whether black is readable on this colour, and white is not.
bool is_light(Rgb c) { return 0.299 * c.red + 0.587 * c.green + 0.114 * c.blue > 140; }

/// Whether what the overlay draws in a pixel is light.
bool is_light_there(const Frame& frame, Pixel pixel) {
    const MeasuredChannels* const measured = wholly_laid_over(frame.state, frame.results);
    if (!measured || measured->channels.size() > 1 || frame.pictures.distributions().empty()) return false;
    const double value = measured->channels.front().at(pixel);
    const Brush* const brush = brush_of(frame.state.overlay);
    return (!brush || is_brushed(*brush, value)) && is_light(frame.pictures.distributions().front().coloring(value));
}

void draw_numbers(const Canvas& canvas) {
    const Frame& frame = canvas.frame;
    const double zoom = frame.state.view.zoom;
    const Picture& picture = frame.results.picture;
    const Scene& scene = *frame.state.scene;
    if (zoom < numbers_from || !picture.image || picture.image->width != scene.width ||
        picture.image->height != scene.height)
        return;
    const bool measured = !frame.state.overlay.measurement.empty();
    const Pixel first = canvas.first(), last = canvas.last();
    const float room = static_cast<float>(zoom);
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
            const ImVec2 corner = canvas.at(x, y);
            const bool overlaid = measured && frame.state.overlay.opacity > 0.5 &&
                                  (frame.state.beside == Beside::nothing ||
                                   (frame.state.beside == Beside::overlay && corner.x + room / 2 > canvas.split()));
            const std::vector<std::string> lines = numbers_in(canvas, x, y, overlaid);
            if (lines.empty()) continue;
            float widest = 1;
            for (const std::string& line : lines)
                widest = std::max(widest, frame.fonts.mono->CalcTextSizeA(100, 1e9f, 0, line.c_str()).x / 100);
            const float size = std::min({room * .9f / widest, room * .9f / static_cast<float>(lines.size()), 24.f});
            const float top = corner.y + (room - size * static_cast<float>(lines.size())) / 2;
            const bool light = overlaid ? is_light_there(frame, {x, y}) : is_light(picture.image->at(x, y));
            const ImU32 black = IM_COL32(0, 0, 0, 255), ink = light ? black : IM_COL32_WHITE;
            for (std::size_t i = 0; i < lines.size(); ++i) {
                const ImVec2 place{corner.x + room * .05f, top + size * static_cast<float>(i)};
                if (overlaid && !light)  // through which the picture may be seen
                    canvas.list.AddText(frame.fonts.mono, size, {place.x + 1, place.y + 1}, black, lines[i].c_str());
                canvas.list.AddText(frame.fonts.mono, size, place, ink, lines[i].c_str());
            }
        }
}

/// Draws a line around the pixels that show the surface that is lit up; what they show stays in sight.
void draw_lit_outline(const Canvas& canvas) {
    const Pixel first = canvas.first(), last = canvas.last();
    const float width = std::max(1.f, ImGui::GetFontSize() / 11);
    for (const auto& [color, its_width] : {std::pair(IM_COL32(0, 0, 0, 160), 2.2f * width), {lit, width}})
        for (const auto& [from, to] : canvas.frame.pictures.lit_outline()) {
            if (to.x < first.x || to.y < first.y || from.x > last.x + 1 || from.y > last.y + 1) continue;
            canvas.list.AddLine(canvas.at(from.x, from.y), canvas.at(to.x, to.y), color, its_width);
        }
}

/// A frame around a pixel that is visible on any colour and at any zoom.
void draw_pin(const Canvas& canvas, Pixel pixel, ImU32 color, const char* name) {
    ImVec2 from = canvas.at(pixel.x, pixel.y), to = canvas.at(pixel.x + 1, pixel.y + 1);
    const float least = 9;
    if (const float grow = (least - (to.x - from.x)) / 2; grow > 0)
        from.x -= grow, from.y -= grow, to.x += grow, to.y += grow;
    canvas.list.AddRect({from.x - 2, from.y - 2}, {to.x + 2, to.y + 2}, IM_COL32(0, 0, 0, 255), 0.f, 0, 3.f);
    canvas.list.AddRect({from.x - 1, from.y - 1}, {to.x + 1, to.y + 1}, color, 0.f, 0, 2.f);
    const ImVec2 size = ImGui::CalcTextSize(name);
    const bool room_above =
        from.y - size.y > canvas.corner.y + 1.5f * ImGui::GetFontSize();  // below the split's labels
    const ImVec2 label{to.x + 5,
                       room_above ? from.y - size.y : std::max(to.y, canvas.corner.y + 1.5f * ImGui::GetFontSize())};
    canvas.list.AddRectFilled({label.x - 2, label.y}, {label.x + size.x + 2, label.y + size.y},
                              canvas.frame.palette.canvas);
    canvas.list.AddText(label, color, name);
}

void draw_split(const Canvas& canvas) {
    ViewerState& state = canvas.frame.state;
    if (state.beside == Beside::nothing) return;
    const float x = canvas.split(), handle = ImGui::GetFontSize() / 2;
    const float middle = canvas.corner.y + canvas.size.y / 2;
    canvas.list.AddLine({x, canvas.corner.y}, {x, canvas.corner.y + canvas.size.y}, IM_COL32(0, 0, 0, 255), 3);
    canvas.list.AddLine({x, canvas.corner.y}, {x, canvas.corner.y + canvas.size.y}, IM_COL32_WHITE, 1);
    canvas.list.AddCircleFilled({x, middle}, handle, IM_COL32(0, 0, 0, 255));
    canvas.list.AddCircle({x, middle}, handle, IM_COL32_WHITE, 0, 2);
    ImGui::SetCursorScreenPos({x - handle, canvas.corner.y});
    ImGui::InvisibleButton("split", {2 * handle, canvas.size.y});
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemActive())
        state.split = std::clamp((ImGui::GetIO().MousePos.x - canvas.corner.x) / canvas.size.x, 0.f, 1.f);
}

/// The label of a side of the split, at its top, from `left` to `right`.
void draw_label(const Canvas& canvas, float left, float right, const std::string& text) {
    const float size = ImGui::GetFontSize(), pad = size / 4, room = right - left - 4 * pad;
    if (room < 4 * size) return;
    const ImVec2 extent = ImGui::CalcTextSize(text.c_str(), nullptr, false, room);
    const ImVec2 corner{left + pad, canvas.corner.y + pad};
    canvas.list.AddRectFilled(corner, {corner.x + extent.x + 2 * pad, corner.y + extent.y + pad},
                              IM_COL32(0, 0, 0, 200), pad);
    canvas.list.AddText(ImGui::GetFont(), size, {corner.x + pad, corner.y + pad / 2}, IM_COL32_WHITE, text.c_str(),
                        nullptr, room);
}

void draw_labels(const Canvas& canvas) {
    const ViewerState& state = canvas.frame.state;
    if (state.beside == Beside::nothing) return;
    const Options& now = state.setup.now().options;
    Options other = now;
    other.scalar = state.other.scalar;
    other.triangle_rule = state.other.triangle_rule;
    other.sphere_rule = state.other.sphere_rule;
    const float split = canvas.split();
    std::string right = state.overlay.measurement.empty() ? "no overlay" : name_of(state.overlay);
    if (state.beside == Beside::other) right = "other: " + how_computed(other);
    if (state.beside == Beside::difference)
        right = fmt::format("difference × {} from: {}", Difference::magnification, how_computed(other));
    if (state.beside == Beside::mine) right = mine_title(state);
    if (state.beside == Beside::mine_difference)
        right = fmt::format("difference × {} from {}", Difference::magnification, mine_title(state));
    draw_label(canvas, canvas.corner.x, split, (shows_mine(state) ? "ours: " : "this: ") + how_computed(now));
    draw_label(canvas, split, canvas.corner.x + canvas.size.x, right);
}

/// How the picture lies now that the area may have another size.
PictureView followed(const PictureView& view, Fit fit, Point area, int width, int height) {
    if (fit == Fit::as_fits) return fitted(area, width, height);
    if (fit == Fit::whole_multiple) return fitted_by_whole_multiple(area, width, height);
    return kept_in_sight(view, area, width, height);
}

/// Returns the pixel of the scene's picture that the mouse is on.
std::optional<Pixel> pointed_at(const Canvas& canvas) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const Pixel p = canvas.frame.state.view.pixel_at({mouse.x - canvas.corner.x, mouse.y - canvas.corner.y});
    if (!(p == canvas.clamped(p))) return {};
    return p;
}

/// Turns the view with the mouse: horizontally about z, vertically about y, half a turn for the picture's width. What
/// is seen follows the mouse if x points at the viewer.
void turn_by_mouse(const Canvas& canvas) {
    ViewerState& state = canvas.frame.state;
    ImVec2 by{};
    for (const ImGuiMouseButton button : {ImGuiMouseButton_Left, ImGuiMouseButton_Right})
        if (ImGui::IsMouseDragging(button)) by = ImGui::GetMouseDragDelta(button);
    if (by.x == 0 && by.y == 0) return;
    const double degrees = 180 / (state.view.zoom * state.scene->width);
    Setup setup = state.setup.before_drag();
    if (by.x != 0) setup = turned(std::move(setup), Axis::z, -std::round(by.x * degrees));
    if (by.y != 0) setup = turned(std::move(setup), Axis::y, -std::round(by.y * degrees));
    state.setup.drag(std::move(setup));
}

void listen_to_mouse(const Canvas& canvas) {
    ViewerState& state = canvas.frame.state;
    const ImGuiIO& io = ImGui::GetIO();
    ImGui::SetCursorScreenPos(canvas.corner);
    ImGui::InvisibleButton("area", canvas.size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    ImGui::SetItemAllowOverlap();
    const bool hovered = ImGui::IsItemHovered();
    state.hovered = hovered ? pointed_at(canvas) : std::nullopt;
    if (hovered && io.MouseWheel != 0) {
        state.fit = Fit::none;
        state.view = zoomed_at(state.view, std::pow(1.25, io.MouseWheel),
                               {io.MousePos.x - canvas.corner.x, io.MousePos.y - canvas.corner.y});
    }
    if (ImGui::IsItemActivated()) {
        state.setup.end_drag();
        state.turning = io.KeyCtrl || io.MouseDown[ImGuiMouseButton_Right];
    }
    if (ImGui::IsItemActive() && state.turning) turn_by_mouse(canvas);
    if (ImGui::IsItemActive() && !state.turning && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
        state.fit = Fit::none;
        state.view = moved(state.view, {io.MouseDelta.x, io.MouseDelta.y});
    }
    // A click is a press that did not move, not even there and back.
    const bool was_dragged = io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] >= std::pow(io.MouseDragThreshold, 2.f);
    if (ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(ImGuiMouseButton_Left) && !was_dragged)
        if (const std::optional<Pixel> pixel = pointed_at(canvas)) {
            if (io.KeyShift) state.compared = pixel;
            else pin(state, pixel);
        }
}

}  // namespace

void draw_picture(const Frame& frame) {
    ViewerState& state = frame.state;
    const Scene& scene = *state.scene;
    const ImVec2 size = ImGui::GetContentRegionAvail();
    if (size.x < 8 || size.y < 8) return;
    const Canvas canvas{frame, *ImGui::GetWindowDrawList(), ImGui::GetCursorScreenPos(), size};
    state.area = {size.x, size.y};
    listen_to_mouse(canvas);
    state.view = followed(state.view, state.fit, state.area, scene.width, scene.height);

    const ImVec2 end{canvas.corner.x + size.x, canvas.corner.y + size.y};
    canvas.list.PushClipRect(canvas.corner, end, true);
    draw_layers(canvas);
    draw_grid(canvas);
    draw_numbers(canvas);
    draw_lit_outline(canvas);
    draw_watched_place(frame, canvas.list, canvas.corner);
    const learn::mine::PictureUpdate* const mine = shows_mine(state) ? frame.results.mine.get() : nullptr;
    if (mine && mine->spot)
        draw_pin(canvas, {mine->spot->x, mine->spot->y}, mine_sign(frame).color, mine_sign(frame).sign);
    if (state.compared) draw_pin(canvas, *state.compared, frame.palette.second, "2");
    if (state.pinned) draw_pin(canvas, *state.pinned, frame.palette.accent, "1");
    draw_split(canvas);
    draw_labels(canvas);
    draw_picture_legend(frame, canvas.corner, size);
    draw_looked_at_banner(frame, canvas.corner, size);
    if (shows_mine(state)) draw_mine_banner(frame, canvas.corner, size, canvas.split());
    canvas.list.PopClipRect();
    draw_file_error(frame, canvas.corner, size);
}

}  // namespace glassbox
