#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "explain/surface_kind.hpp"
#include "explain/words.hpp"
#include "output/legend_number.hpp"
#include "render/view.hpp"
#include "viewer/model/story/cursor.hpp"
#include "viewer/model/work/watching.hpp"
#include "viewer/ui/space/boxes.hpp"
#include "viewer/ui/space/labels.hpp"
#include "viewer/ui/space/painter.hpp"

namespace glassbox {

namespace {

/// Points of the screen, with what is shown when the mouse is on them.
struct Hint {
    ImVec2 at;
    std::string says;
};

void paint_light(const SpaceCanvas& canvas, Labels& labels, std::vector<Hint>& hints) {
    if (!canvas.drawing.has_light) return;
    const Ball& sight = canvas.drawing.sight;
    const Vec3<double> l = canvas.drawing.light, middle = canvas.camera.middle;
    // As far out as it is visible.
    const auto seen = visible_part(canvas.camera, middle, middle + sight.radius * l);
    if (!seen) return;
    const Vec3<double> towards_sun = seen->second - middle, sun = middle + 0.85 * towards_sun;
    const ImU32 color = color_of(canvas.frame.palette, Ink::light);
    const ImVec2 at = canvas.on_screen(sun);
    const float r = ImGui::GetFontSize() * .32f;
    if (const auto tip = paint_arrow(canvas, sun - 0.1 * towards_sun, sun - 0.3 * towards_sun, color, line_width()))
        labels.keep_off_line(at, *tip);
    canvas.list.AddCircleFilled(at, r, color);
    for (int i = 0; i < 8; ++i) {
        const auto [c, s] = cos_sin(45.f * static_cast<float>(i));
        canvas.list.AddLine({at.x + c * r * 1.4f, at.y + s * r * 1.4f}, {at.x + c * r * 2, at.y + s * r * 2}, color,
                            line_width());
    }
    labels.keep_free({at.x - 2 * r, at.y - 2 * r}, {at.x + 2 * r, at.y + 2 * r});
    labels.put(at, 2 * r, "light", color);
    hints.push_back({at, "The light comes from this direction; it is too far away for its distance to count"});
}

void paint_axes(const SpaceCanvas& canvas, Labels& labels, std::vector<Hint>& hints) {
    const Vec3<double> from = canvas.drawing.axes_at;
    const bool at_origin = from == Vec3<double>{};
    const double size = canvas.drawing.axis_length;
    const ImU32 color = canvas.frame.palette.faint_text;
    const std::string said =
        fmt::format("The world's axes, {} long{}", legend_number(size),
                    at_origin ? ", from its origin" : "; not from the origin, which is out of sight");
    const std::pair<const char*, Vec3<double>> axes[] = {{"x", {size, 0, 0}}, {"y", {0, size, 0}}, {"z", {0, 0, size}}};
    for (const auto& [name, axis] : axes) {
        const auto tip = paint_arrow(canvas, from, from + axis, color, line_width());
        if (!tip) continue;
        labels.put(*tip, line_width() * 2, at_origin ? fmt::format("{} {}", name, legend_number(size)) : name, color);
        hints.push_back({*tip, said});
    }
}

/// An arrow's name, to be put at its tip.
struct NamedTip {
    ImVec2 at;
    const char* name;
    ImU32 color;
};

/// Draws the vectors at the first hit; words are to keep off them.
std::vector<NamedTip> paint_arrows(const SpaceCanvas& canvas, Labels& labels) {
    std::vector<NamedTip> tips;
    for (const ArrowInSpace& arrow : canvas.drawing.arrows) {
        if (!in_front(canvas.camera, arrow.from)) continue;
        // The light's arrow is longer: the half vector may lie on it.
        const double size =
            (arrow.ink == Ink::light ? 4 : 3.2) * ImGui::GetFontSize() * length_of_pixel(canvas.camera, arrow.from);
        const ImU32 color = color_of(canvas.frame.palette, arrow.ink);
        // The one towards the viewer lies on the ray, and must be seen on it.
        const float width = line_width() * (arrow.ink == Ink::viewer ? 2.6f : 1.6f);
        const auto tip = paint_arrow(canvas, arrow.from, arrow.from + size * arrow.direction, color, width);
        if (!tip) continue;
        labels.keep_off_line(canvas.on_screen(arrow.from), *tip);
        tips.push_back({*tip, arrow.name, color});
    }
    return tips;
}

void keep_off_rays(const SpaceCanvas& canvas, Labels& labels) {
    for (const LineInSpace& line : canvas.drawing.lines)
        if (line.ink == Ink::pinned || line.ink == Ink::second)
            if (const auto seen = visible_part(canvas.camera, line.from, line.to))
                labels.keep_off_line(canvas.on_screen(seen->first), canvas.on_screen(seen->second));
}

void paint_labels(const SpaceCanvas& canvas, Labels& labels, std::vector<Hint>& hints) {
    const float r = ImGui::GetFontSize() * .2f;
    for (const LabelInSpace& label : canvas.drawing.labels) {
        if (!in_front(canvas.camera, label.at)) continue;
        const ImVec2 at = canvas.on_screen(label.at);
        const ImU32 color = color_of(canvas.frame.palette, label.ink);
        if (label.dot) {
            canvas.list.AddCircleFilled(at, label.text.empty() ? r * .7f : r, color);
            canvas.list.AddCircle(at, label.text.empty() ? r * .7f : r, canvas.frame.palette.canvas);
        }
        const double room = label.room / length_of_pixel(canvas.camera, label.at);
        if (label.room > 0 && room < 4 * ImGui::GetFontSize()) continue;
        if (!label.text.empty()) labels.put(at, label.dot ? r * 1.5f : r, label.text, color);
        if (!label.hint.empty()) hints.push_back({at, label.hint});
    }
}

void paint_lit(const SpaceCanvas& canvas, const Triangle<double>& triangle) {
    const auto& [A, B, C] = triangle;
    for (const auto& [from, to] : {std::pair(A, B), {B, C}, {C, A}})
        paint_line(canvas, from, to, canvas.frame.palette.warning, 2.5f * line_width());
}

void paint_lit(const SpaceCanvas& canvas, const Sphere<double>& sphere) {
    if (!in_front(canvas.camera, sphere.C)) return;
    const double radius = sphere.r / length_of_pixel(canvas.camera, sphere.C);
    canvas.list.AddCircle(canvas.on_screen(sphere.C), static_cast<float>(std::min(radius, 1e5)),
                          canvas.frame.palette.warning, 64, 2.5f * line_width());
}

/// Draws the outline of the surface that is lit up, also through others: one of the story, or of those drawn.
void paint_lit_surface(const SpaceCanvas& canvas) {
    const Frame& frame = canvas.frame;
    if (const story::Surface* const lit = lit_in_story(frame.state, frame.results)) {
        if (const auto* test = std::get_if<story::TriangleTest>(&lit->test))
            return paint_lit(canvas, Triangle<double>{test->vertices[0], test->vertices[1], test->vertices[2]});
        const auto& sphere = std::get<story::SphereTest>(lit->test);
        return paint_lit(canvas, Sphere<double>{sphere.center, sphere.radius});
    }
    const std::optional<std::size_t> lit = lit_surface(frame.state, frame.results);
    if (!lit) return;
    const auto& [spheres, triangles] = canvas.surfaces.shown;
    const std::vector<std::size_t>& numbers = canvas.surfaces.numbers;
    const auto at = static_cast<std::size_t>(std::ranges::find(numbers, *lit) - numbers.begin());
    if (at < spheres.size()) paint_lit(canvas, spheres[at]);
    else if (at < numbers.size() && !canvas.surfaces.coarser) paint_lit(canvas, triangles[at - spheres.size()]);
}

/// Draws the ray of the pixel that is traced while one watches.
void paint_watched_ray(const SpaceCanvas& canvas) {
    const ViewerState& state = canvas.frame.state;
    if (!state.watching.on) return;
    const double last = pixels(state) - 1;
    const LoopPlace place =
        loop_place(static_cast<std::size_t>(std::clamp(state.watching.shown, 0.0, last)), state.scene->height);
    const Ray<double> ray = std::visit([&](const auto& view) { return pixel_ray(view, place.column, place.row); },
                                       canvas.drawing.picture.view);
    const Ball& sight = canvas.drawing.sight;
    const double end = (length(ray.P - sight.center) + sight.radius) / length(ray.D);
    paint_line(canvas, ray.P, at(ray, end), canvas.frame.palette.warning, 1.5f * line_width());
}

/// Says what is not drawn.
std::string caption(const SurfacesInSpace& surfaces, bool with_mesh_boxes) {
    std::string text;
    const std::size_t spheres = surfaces.shown.spheres.size(), triangles = surfaces.shown.triangles.size();
    if (surfaces.coarser)
        text += fmt::format("{} triangles drawn as {} coarser ones. ", surfaces.all_triangles, triangles);
    else if (triangles < surfaces.all_triangles)
        text += fmt::format("{} of {} triangles drawn{}. ", triangles, surfaces.all_triangles,
                            with_mesh_boxes ? ", and the boxes around their meshes" : "");
    if (spheres < surfaces.all_spheres) text += fmt::format("{} of {} spheres drawn. ", spheres, surfaces.all_spheres);
    if (surfaces.far > 0)
        text += fmt::format("{} too far away to be seen here: turn the wheel back to see {}. ",
                            surfaces.far == 1 ? "1 surface is" : fmt::format("{} surfaces are", surfaces.far),
                            surfaces.far == 1 ? "it" : "them");
    return text;
}

void paint_caption(const SpaceCanvas& canvas, Labels& labels, float top) {
    const std::string text = caption(canvas.surfaces, !canvas.frame.boxes.shown());
    if (text.empty()) return;
    const float pad = ImGui::GetFontSize() * .3f, width = static_cast<float>(canvas.camera.area.x) - 2 * pad;
    const ImVec2 at{canvas.corner.x + pad, top};
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, width);
    labels.keep_free(at, {at.x + size.x, at.y + size.y});
    canvas.list.AddRectFilled({at.x - pad, at.y}, {at.x + size.x + pad, at.y + size.y},
                              faded(canvas.frame.palette.canvas, .85));
    canvas.list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), at, canvas.frame.palette.faint_text, text.c_str(),
                        nullptr, width);
}

std::string said_of(const SpaceCanvas& canvas, const SeenInSpace& seen, ImVec2 mouse, const std::vector<Hint>& hints) {
    const Hint* nearest = nullptr;
    float least = ImGui::GetFontSize() * .6f;
    for (const Hint& hint : hints) {
        const float distance = std::hypot(hint.at.x - mouse.x, hint.at.y - mouse.y);
        if (distance < least) least = distance, nearest = &hint;
    }
    if (nearest) return nearest->says;
    if (seen.on_picture)
        return fmt::format("The picture: pixel {}, {}{}", static_cast<int>(seen.on_picture->x),
                           static_cast<int>(seen.on_picture->y),
                           canvas.drawing.picture.t > 0
                               ? fmt::format("\nIt is drawn at t = {} of its rays; the viewing plane is at t = 1",
                                             legend_number(canvas.drawing.picture.t))
                               : "");
    if (seen.surface)
        return fmt::format("Surface {}, a {}", *seen.surface, word(kind_of(*canvas.frame.state.scene, *seen.surface)));
    return "Drag to look from elsewhere, Shift+drag to shift, wheel to come closer, double click to go back";
}

void listen_to_mouse(const Frame& frame, ImVec2 size) {
    ViewerState& state = frame.state;
    ImGui::InvisibleButton("in space", size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemHovered()) {
        if (io.MouseWheel != 0) state.orbit = closer(state.orbit, std::pow(1.15, -io.MouseWheel));
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) state.orbit = Orbit{};
    }
    const Point by{io.MouseDelta.x, io.MouseDelta.y};
    if (!ImGui::IsItemActive() || by == Point{}) return;
    state.flight.reset();
    const bool shifts = io.KeyShift || ImGui::IsMouseDown(ImGuiMouseButton_Middle);
    state.orbit = shifts ? panned(state.orbit, by, {size.x, size.y}) : dragged(state.orbit, by, ImGui::GetFontSize());
}

}  // namespace

void draw_space(const Frame& frame) {
    const ImVec2 size = ImGui::GetContentRegionAvail(), corner = ImGui::GetCursorScreenPos();
    if (size.x < 8 || size.y < 8) return;
    // The buttons come first, so that they get the clicks, and lie on top.
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.ChannelsSplit(2);
    list.ChannelsSetCurrent(1);
    const float pad = ImGui::GetFontSize() * .3f;
    const ImVec2 buttons{corner.x + pad, corner.y + pad}, buttons_end = draw_box_buttons(frame, buttons);
    list.ChannelsSetCurrent(0);
    ImGui::SetCursorScreenPos(corner);
    listen_to_mouse(frame, size);
    const bool hovered =
        ImGui::IsItemHovered() && !ImGui::IsItemActive() && !ImGui::IsMouseHoveringRect(buttons, buttons_end);

    const SurfacesInSpace& surfaces = frame.space.surfaces();
    const SpaceDrawing& drawing = frame.space.drawing();
    const InPane shown{drawing.sight, drawing.focus, drawing.outline, surfaces.upright, {size.x, size.y}};
    const SpaceCanvas canvas{frame, surfaces, drawing, list, corner, camera_of(frame.state.orbit, shown)};
    const ImVec2 end{corner.x + size.x, corner.y + size.y};
    canvas.list.PushClipRect(corner, end, true);
    paint_sorted(canvas);
    paint_lit_surface(canvas);
    paint_watched_ray(canvas);
    Labels labels(canvas.list, corner, end, faded(frame.palette.canvas, .65));
    std::vector<Hint> hints;
    labels.keep_free(buttons, buttons_end);
    list.ChannelsSetCurrent(1);  // on top, too, so that no dot or line goes through the words
    paint_caption(canvas, labels, paint_box_legend(canvas, labels, buttons_end.y + pad));
    list.ChannelsSetCurrent(0);
    keep_off_rays(canvas, labels);
    const std::vector<NamedTip> tips = paint_arrows(canvas, labels);
    paint_labels(canvas, labels, hints);
    for (const auto& [at, name, color] : tips) labels.put(at, line_width() * 2, name, color);
    paint_light(canvas, labels, hints);
    paint_axes(canvas, labels, hints);
    canvas.list.PopClipRect();
    list.ChannelsMerge();

    if (!hovered) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const SeenInSpace seen = seen_at(canvas.camera, {mouse.x - corner.x, mouse.y - corner.y}, surfaces, drawing);
    frame.state.pointing_at = seen.surface;
    ImGui::SetTooltip("%s", said_of(canvas, seen, mouse, hints).c_str());
}

}  // namespace glassbox
