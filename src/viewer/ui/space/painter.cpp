#include "viewer/ui/space/painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <reflection.hpp>

#include "viewer/ui/space/boxes.hpp"

namespace glassbox {

namespace {

constexpr int cells = 12;  // of the picture, on each side: perspective is nearly linear within a cell

/// Something to draw, and its depth in front of the eye.
struct Item {
    enum class Kind { part, sphere, cell, line, edge } kind;
    double depth;
    std::size_t index;
    double from = 0, to = 0;  ///< of a line: the part of it
};

/// A piece of a box's edge.
struct EdgePiece {
    Vec3<double> from, to;
    Passage passage;
    bool ended;
};

ImU32 shaded(Rgb color, double light, double opacity) {
    const auto channel = [&](int value) { return static_cast<int>(std::lround(std::min(255.0, value * light))); };
    return IM_COL32(channel(color.red), channel(color.green), channel(color.blue), std::lround(255 * opacity));
}

/// How bright a surface is: as if lit by a lamp above the camera's left shoulder.
double brightness(const SpaceCanvas& canvas, const Vec3<double>& n) {
    const Camera& c = canvas.camera;
    const Vec3<double> lamp = unit(c.back + 0.6 * c.up - 0.5 * c.right);
    return 0.4 + 0.62 * positive_part(dot(n, lamp));
}

ImU32 edge_color(const SpaceCanvas& canvas, double opacity) {
    return canvas.frame.state.appearance.dark ? shaded({255, 255, 255}, 1, opacity) : shaded({}, 1, opacity);
}

/// Whether all corners lie on the same outer side of the pane.
bool is_out_of_sight(const SpaceCanvas& canvas, const std::array<ImVec2, 3>& at) {
    const ImVec2 low = canvas.corner, high{low.x + static_cast<float>(canvas.camera.area.x),
                                           low.y + static_cast<float>(canvas.camera.area.y)};
    const auto all = [&](const auto& is_outside) { return std::all_of(at.begin(), at.end(), is_outside); };
    return all([&](ImVec2 p) { return p.x < low.x; }) || all([&](ImVec2 p) { return p.x > high.x; }) ||
           all([&](ImVec2 p) { return p.y < low.y; }) || all([&](ImVec2 p) { return p.y > high.y; });
}

void paint_part(const SpaceCanvas& canvas, const SurfacesInSpace::Part& part, double edge_opacity) {
    std::array<ImVec2, 3> at;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!in_front(canvas.camera, part.corners[i])) return;
        at[i] = canvas.on_screen(part.corners[i]);
    }
    if (is_out_of_sight(canvas, at)) return;
    const std::size_t color = canvas.surfaces.shown.spheres.size() + part.triangle;
    // Both sides are equally bright.
    const Vec3<double> n = normal(canvas.surfaces.shown.triangles[part.triangle]);
    const Vec3<double> facing = towards(eye(canvas.camera) - part.corners[0], n);
    const double light = is_finite(n) ? brightness(canvas, facing) : 1;
    canvas.list.AddTriangleFilled(at[0], at[1], at[2], shaded(canvas.surfaces.colors[color], light, 0.82));
    if (edge_opacity == 0) return;
    // The edges of tiny triangles would only tint them, and there are very many.
    constexpr float tiny = 4;  // pixels
    const auto [left, right] = std::minmax({at[0].x, at[1].x, at[2].x});
    const auto [top, bottom] = std::minmax({at[0].y, at[1].y, at[2].y});
    if (right - left < tiny && bottom - top < tiny) return;
    for (std::size_t i = 0; i < 3; ++i)
        if (part.on_its_edge[i])
            canvas.list.AddLine(at[i], at[(i + 1) % 3], edge_color(canvas, edge_opacity), line_width() * 0.7f);
}

/// Circles around a sphere's poles. Those on the far side shine through.
void paint_latitudes(const SpaceCanvas& canvas, const Sphere<double>& sphere, int segments, bool near_side) {
    const Vec3<double> up = canvas.surfaces.upright.up, front = canvas.surfaces.upright.front;
    const Vec3<double> side = cross(up, front), to_eye = eye(canvas.camera) - sphere.C;
    for (const double latitude : {-45.0, 0.0, 45.0}) {
        const auto [cos_l, sin_l] = cos_sin(latitude);
        std::array<Vec3<double>, 2> last;
        for (int i = 0; i <= segments; ++i) {
            const auto [c, s] = cos_sin(360.0 * i / segments);
            last[1] = sphere.C + sphere.r * (cos_l * (c * front + s * side) + sin_l * up);
            const bool is_near = dot(last[1] - sphere.C, to_eye) > sphere.r * sphere.r;
            if (i > 0 && is_near == near_side && in_front(canvas.camera, last[0]) && in_front(canvas.camera, last[1]))
                canvas.list.AddLine(canvas.on_screen(last[0]), canvas.on_screen(last[1]),
                                    edge_color(canvas, near_side ? 0.3 : 0.1), line_width() * 0.7f);
            last[0] = last[1];
        }
    }
}

/// The side of a sphere that the camera sees, in rings around the point nearest to it, with its exact outline.
void paint_sphere(const SpaceCanvas& canvas, std::size_t index) {
    const Sphere<double>& sphere = canvas.surfaces.shown.spheres[index];
    const Rgb color = canvas.surfaces.colors[index];
    const Vec3<double> to_eye = eye(canvas.camera) - sphere.C;
    const double distance = length(to_eye);
    if (!in_front(canvas.camera, sphere.C) || !(distance > 1.001 * sphere.r)) return;
    const double pixels = sphere.r / length_of_pixel(canvas.camera, sphere.C);
    if (pixels < 1.5) {
        canvas.list.AddCircleFilled(canvas.on_screen(sphere.C), std::max(1.5f, line_width()), shaded(color, 1, 1), 8);
        return;
    }
    const int segments = std::clamp(static_cast<int>(6 * std::sqrt(pixels)), 10, 64), rings = segments / 5;
    paint_latitudes(canvas, sphere, segments, false);

    const Vec3<double> w = unit(to_eye);
    const Vec3<double> u = unit(cross(canvas.camera.up, w)), v = cross(w, u);
    const double widest = std::acos(sphere.r / distance);
    const ImVec2 uv = ImGui::GetFontTexUvWhitePixel();
    std::vector<ImVec2> outline;
    canvas.list.PrimReserve(6 * segments * (rings - 1) + 3 * segments, 1 + segments * rings);
    const auto first = static_cast<ImDrawIdx>(canvas.list._VtxCurrentIdx);
    const auto write = [&](const Vec3<double>& n) {
        const ImVec2 at = canvas.on_screen(sphere.C + sphere.r * n);
        canvas.list.PrimWriteVtx(at, uv, shaded(color, brightness(canvas, n), 0.88));
        return at;
    };
    write(w);
    for (int ring = 1; ring <= rings; ++ring)
        for (int i = 0; i < segments; ++i) {
            const double angle = widest * ring / rings;
            const auto [c, s] = cos_sin(360.0 * i / segments);
            const ImVec2 at = write(std::cos(angle) * w + std::sin(angle) * (c * u + s * v));
            if (ring == rings) outline.push_back(at);
        }
    const auto vertex = [&](int ring, int i) {
        return static_cast<ImDrawIdx>(ring == 0 ? first : first + 1 + (ring - 1) * segments + i % segments);
    };
    for (int ring = 0; ring < rings; ++ring)
        for (int i = 0; i < segments; ++i) {
            const auto triangle = [&](ImDrawIdx a, ImDrawIdx b, ImDrawIdx c) {
                canvas.list.PrimWriteIdx(a);
                canvas.list.PrimWriteIdx(b);
                canvas.list.PrimWriteIdx(c);
            };
            triangle(vertex(ring, i), vertex(ring + 1, i), vertex(ring + 1, i + 1));
            if (ring > 0) triangle(vertex(ring, i), vertex(ring + 1, i + 1), vertex(ring, i + 1));
        }
    canvas.list.AddPolyline(outline.data(), static_cast<int>(outline.size()), edge_color(canvas, 0.55),
                            ImDrawFlags_Closed, line_width());
    if (pixels > ImGui::GetFontSize() / 2) paint_latitudes(canvas, sphere, segments, true);
}

std::array<Vec3<double>, 4> cell_corners(const PictureInSpace& picture, std::size_t index) {
    const double left = static_cast<double>(index % cells), top = static_cast<double>(index / cells);
    const auto at = [&](double x, double y) {
        return picture.at(x * picture.width / cells, y * picture.height / cells);
    };
    return {at(left, top), at(left + 1, top), at(left + 1, top + 1), at(left, top + 1)};
}

void paint_cell(const SpaceCanvas& canvas, std::size_t index) {
    const auto corners = cell_corners(canvas.drawing.picture, index);
    std::array<ImVec2, 4> at;
    for (std::size_t i = 0; i < 4; ++i) {
        if (!in_front(canvas.camera, corners[i])) return;
        at[i] = canvas.on_screen(corners[i]);
    }
    const Texture& texture = canvas.frame.pictures.picture();
    if (texture.empty()) {
        canvas.list.AddQuadFilled(at[0], at[1], at[2], at[3], faded(canvas.frame.palette.line, .5));
        return;
    }
    const float left = static_cast<float>(index % cells) / cells, top = static_cast<float>(index / cells) / cells;
    constexpr float one = 1.f / cells;
    canvas.list.AddImageQuad(texture.id(), at[0], at[1], at[2], at[3], {left, top}, {left + one, top},
                             {left + one, top + one}, {left, top + one}, IM_COL32(255, 255, 255, 215));
}

Vec3<double> along(const LineInSpace& line, double part) {
    return part == 0 ? line.from : part == 1 ? line.to : line.from + part * (line.to - line.from);
}

/// Cuts a line into pieces that are sorted one by one, with gaps if it is dashed. Pieces far away are longer.
void add_pieces(std::vector<Item>& items, const SpaceCanvas& canvas, std::size_t index) {
    const LineInSpace& line = canvas.drawing.lines[index];
    const double all = length(line.to - line.from);
    const double shortest = canvas.drawing.sight.radius / 40 * std::min(1.0, canvas.frame.state.orbit.distance);
    bool gap = false;
    constexpr int most = 2000;
    double from = 0;
    for (int i = 0; i < most && from < all; ++i) {
        const double to = i + 1 == most ? all : std::min(all, from + std::max(shortest, from / 40));
        if (!(line.dashed && gap)) {
            const double middle = dot(along(line, (from + to) / 2 / all) - canvas.camera.middle, canvas.camera.back);
            items.push_back({Item::Kind::line, canvas.camera.distance - middle, index, from / all, to / all});
        }
        gap = !gap;
        from = to;
    }
}

/// Returns the visible parts of the boxes' edges, in pieces that are sorted one by one; of dashed edges every other
/// piece.
std::vector<EdgePiece> edge_pieces(const SpaceCanvas& canvas) {
    std::vector<EdgePiece> pieces;
    if (!canvas.frame.boxes.shown()) return pieces;
    const double longest = canvas.drawing.sight.radius / 12 * std::min(1.0, canvas.frame.state.orbit.distance);
    const double dash = .4 * ImGui::GetFontSize();  // pixels
    constexpr double most = 200;
    for (const BoxInSpace& box : canvas.frame.boxes.shown()->drawn)
        for (int n = 0; n < 12; ++n) {
            const auto [one, other] = edge(box, n);
            const auto seen = visible_part(canvas.camera, one, other);
            if (!seen) continue;
            const auto& [from, to] = *seen;
            const bool dashed = line_of(canvas, box.passage).dashed;
            const ImVec2 a = canvas.on_screen(from), b = canvas.on_screen(to);
            const double wanted = dashed ? std::hypot(b.x - a.x, b.y - a.y) / dash : length(to - from) / longest;
            const int whole = static_cast<int>(std::clamp(std::ceil(wanted), dashed ? 3.0 : 1.0, most));
            const int count = dashed ? whole | 1 : whole;  // an odd number begins and ends with a dash
            for (int i = 0; i < count; i += dashed ? 2 : 1)
                pieces.push_back({from + 1.0 * i / count * (to - from), from + (i + 1.0) / count * (to - from),
                                  box.passage, box.ended});
        }
    return pieces;
}

void paint_edge(const SpaceCanvas& canvas, const EdgePiece& piece, double part) {
    const BoxLine line = line_of(canvas, piece.passage);
    const bool fainter = piece.ended && piece.passage == Passage::missed;
    paint_line(canvas, piece.from, piece.to, faded(line.color, fainter ? .6 * part : part), line.width);
}

std::vector<Item> sorted_items(const SpaceCanvas& canvas, const std::vector<EdgePiece>& edges) {
    const Camera& camera = canvas.camera;
    const auto depth = [&](const Vec3<double>& point) {
        return camera.distance - dot(point - camera.middle, camera.back);
    };
    std::vector<Item> items;
    const auto& parts = canvas.surfaces.parts;
    items.reserve(parts.size() + edges.size() + 1000);  // in most scenes that is all
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto& [A, B, C] = parts[i].corners;
        items.push_back({Item::Kind::part, depth((A + B + C) / 3), i});
    }
    const auto& spheres = canvas.surfaces.shown.spheres;
    for (std::size_t i = 0; i < spheres.size(); ++i) items.push_back({Item::Kind::sphere, depth(spheres[i].C), i});
    for (std::size_t i = 0; i < cells * cells; ++i) {
        const auto c = cell_corners(canvas.drawing.picture, i);
        items.push_back({Item::Kind::cell, depth((c[0] + c[2]) / 2), i});
    }
    for (std::size_t i = 0; i < canvas.drawing.lines.size(); ++i) add_pieces(items, canvas, i);
    for (std::size_t i = 0; i < edges.size(); ++i)
        items.push_back({Item::Kind::edge, depth((edges[i].from + edges[i].to) / 2), i});
    std::stable_sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.depth > b.depth; });
    return items;
}

void paint_box(const SpaceCanvas& canvas, const std::array<Vec3<double>, 2>& box) {
    const auto corner = [&](int i) {
        return Vec3<double>{i & 1 ? box[1].x : box[0].x, i & 2 ? box[1].y : box[0].y, i & 4 ? box[1].z : box[0].z};
    };
    for (int i = 0; i < 8; ++i)
        for (const int bit : {1, 2, 4})
            if (!(i & bit))
                paint_line(canvas, corner(i), corner(i | bit), canvas.frame.palette.faint_text, line_width());
}

float width_of(const LineInSpace& line) { return line_width() * static_cast<float>(line.width); }

}  // namespace

ImU32 color_of(const Palette& palette, Ink ink) {
    switch (ink) {
        case Ink::plain:
            return palette.text;
        case Ink::faint:
            return palette.faint_text;
        case Ink::pinned:
            return palette.accent;
        case Ink::second:
            return palette.second;
        case Ink::light:
            return palette.n_l;
        case Ink::viewer:
            return palette.n_r;
        case Ink::half_vector:
            return palette.n_h;
        case Ink::a:
            return palette.a;
        case Ink::b:
            return palette.b;
        case Ink::c:
            return palette.c;
    }
    return palette.text;
}

ImU32 faded(ImU32 color, double part) {
    const auto alpha = static_cast<double>(color >> IM_COL32_A_SHIFT & 0xFF) * part;
    return (color & ~IM_COL32_A_MASK) | static_cast<ImU32>(std::lround(alpha)) << IM_COL32_A_SHIFT;
}

float line_width() { return std::max(1.f, ImGui::GetFontSize() / 13); }

void paint_line(const SpaceCanvas& canvas, const Vec3<double>& from, const Vec3<double>& to, ImU32 color, float width) {
    if (const auto seen = visible_part(canvas.camera, from, to))
        canvas.list.AddLine(canvas.on_screen(seen->first), canvas.on_screen(seen->second), color, width);
}

std::optional<ImVec2> paint_arrow(const SpaceCanvas& canvas, const Vec3<double>& from, const Vec3<double>& to,
                                  ImU32 color, float width) {
    paint_line(canvas, from, to, color, width);
    if (!in_front(canvas.camera, to) || !in_front(canvas.camera, from)) return {};
    const ImVec2 tip = canvas.on_screen(to), tail = canvas.on_screen(from);
    const float dx = tip.x - tail.x, dy = tip.y - tail.y, size = std::hypot(dx, dy);
    const float head = std::min(size, width * 4);
    if (size > 0) {
        const ImVec2 d{dx / size * head, dy / size * head};
        canvas.list.AddTriangleFilled(tip, {tip.x - d.x - d.y * .5f, tip.y - d.y + d.x * .5f},
                                      {tip.x - d.x + d.y * .5f, tip.y - d.y - d.x * .5f}, color);
    }
    return tip;
}

void paint_sorted(const SpaceCanvas& canvas) {
    // Anti-aliased edges would show as seams between the parts of a triangle.
    const ImDrawListFlags before = canvas.list.Flags;
    const bool has_edges = edges_are_seen(canvas.surfaces, canvas.camera);
    const double edge_opacity = !has_edges ? 0 : canvas.surfaces.shown.triangles.size() > 200 ? 0.18 : 0.5;
    if (!canvas.frame.boxes.shown())
        for (const auto& box : canvas.surfaces.boxes) paint_box(canvas, box);
    const std::vector<EdgePiece> edges = edge_pieces(canvas);
    for (const Item& item : sorted_items(canvas, edges)) {
        canvas.list.Flags = before & ~ImDrawListFlags_AntiAliasedFill;
        switch (item.kind) {
            case Item::Kind::part:
                paint_part(canvas, canvas.surfaces.parts[item.index], edge_opacity);
                break;
            case Item::Kind::sphere:
                paint_sphere(canvas, item.index);
                break;
            case Item::Kind::cell:
                paint_cell(canvas, item.index);
                break;
            case Item::Kind::edge:
                paint_edge(canvas, edges[item.index], 1);
                break;
            case Item::Kind::line:
                const LineInSpace& line = canvas.drawing.lines[item.index];
                paint_line(canvas, along(line, item.from), along(line, item.to),
                           color_of(canvas.frame.palette, line.ink), width_of(line));
        }
    }
    canvas.list.Flags = before;
    for (const EdgePiece& piece : edges)
        if (piece.passage != Passage::missed) paint_edge(canvas, piece, .4);
    for (const LineInSpace& line : canvas.drawing.lines)
        paint_line(canvas, line.from, line.to, faded(color_of(canvas.frame.palette, line.ink), line.dashed ? .2 : .4),
                   width_of(line));
}

}  // namespace glassbox
