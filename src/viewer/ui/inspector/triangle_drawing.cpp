#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "viewer/ui/inspector/drawings.hpp"

namespace glassbox {

namespace {

using namespace story;

struct Flat {
    double x, y;
};

/// Projects points for a viewer who looks along D: x to the right, y up, the ray's start in the middle.
class Looking {
public:
    explicit Looking(const Ray<double>& ray) : P_(ray.P) {
        const Vec3<double> forward = unit(ray.D);
        const Vec3<double> up = std::abs(forward.z) < .99 ? Vec3<double>{0, 0, 1} : Vec3<double>{0, 1, 0};
        right_ = unit(cross(forward, up));
        up_ = cross(right_, forward);
    }
    Flat operator()(const Vec3<double>& point) const {
        const Vec3<double> from = point - P_;
        return {dot(from, right_), dot(from, up_)};
    }

private:
    Vec3<double> P_, right_, up_;
};

const char* sign_of(const Number& n) {
    const bool known = n.known != Known::not_at_all;
    if (!known) return "?";
    return n.sign > 0 ? "+" : n.sign < 0 ? "−" : "0";
}

/// The square part of that plane that is shown on the canvas.
struct Window {
    Flat middle{};
    double half = 1;

    ImVec2 on(const Canvas& canvas, Flat p) const {
        const ImVec2 size = canvas.size();
        const double scale = std::min(size.x, size.y) / 2 / half;
        const auto bounded = [](double v) { return static_cast<float>(std::clamp(v, -1e5, 1e5)); };
        return canvas.at(size.x / 2 + bounded((p.x - middle.x) * scale),
                         size.y / 2 - bounded((p.y - middle.y) * scale));
    }
};

Window around(std::span<const Flat> points, double margin) {
    const auto [left, right] =
        std::minmax_element(points.begin(), points.end(), [](Flat a, Flat b) { return a.x < b.x; });
    const auto [low, high] =
        std::minmax_element(points.begin(), points.end(), [](Flat a, Flat b) { return a.y < b.y; });
    const double half = std::max(right->x - left->x, high->y - low->y) / 2;
    return {{(left->x + right->x) / 2, (low->y + high->y) / 2}, half > 0 ? half * margin : 1};
}

bool has_place(Flat p) { return std::isfinite(p.x) && std::isfinite(p.y); }

}  // namespace

void draw_triangle(const Frame& frame, const Ray<double>& ray, const Surface& surface, float width, ImU32 color) {
    const auto& test = std::get<TriangleTest>(surface.test);
    const Looking look(ray);
    // The ray's own point is last.
    const std::array<Flat, 4> points{look(test.vertices[0]), look(test.vertices[1]), look(test.vertices[2]), {0, 0}};
    if (!std::all_of(points.begin(), points.end(), has_place)) {
        ImGui::TextWrapped("Its coordinates are not finite: it cannot be drawn.");
        return;
    }
    const Flat spot = points[3];
    Window window = around(std::span(points).first(3), 2.2);
    const double away = std::max(std::abs(spot.x - window.middle.x), std::abs(spot.y - window.middle.y)) / window.half;
    const bool far = away > 1.8;
    if (!far) window = around(points, 1.6);

    const float unit = ImGui::GetFontSize();
    const Canvas canvas(frame, {width, std::min(width * .75f, 11 * unit)});
    const Palette& palette = canvas.palette();
    canvas.list().AddRect(canvas.at(0, 0), canvas.at(canvas.size().x, canvas.size().y), palette.line);
    const std::array<ImVec2, 3> corner{window.on(canvas, points[0]), window.on(canvas, points[1]),
                                       window.on(canvas, points[2])};
    canvas.list().AddTriangleFilled(corner[0], corner[1], corner[2], to_color(surface.color, 60));
    const ImVec2 center{(corner[0].x + corner[1].x + corner[2].x) / 3, (corner[0].y + corner[1].y + corner[2].y) / 3};
    const auto outwards = [&](ImVec2 from, float by) {
        const float dx = from.x - center.x, dy = from.y - center.y, length = std::hypot(dx, dy);
        return length > 0 ? ImVec2{from.x + dx / length * by, from.y + dy / length * by} : ImVec2{from.x, from.y - by};
    };
    struct Edge {
        std::size_t from, to;
        const char* name;
        const Number& side;
        ImU32 color;
    };
    for (const Edge& edge :
         {Edge{1, 2, "a", test.a, palette.a}, Edge{2, 0, "b", test.b, palette.b}, Edge{0, 1, "c", test.c, palette.c}}) {
        const ImVec2 from = corner[edge.from], to = corner[edge.to];
        const ImVec2 middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
        canvas.line(from, to, edge.color, 3);
        canvas.arrow_head(from, {from.x + (to.x - from.x) * .58f, from.y + (to.y - from.y) * .58f}, edge.color);
        // Perpendicular to the edge, away from the vertex that is not on it.
        const ImVec2 third = corner[3 - edge.from - edge.to];
        const float length = std::max(1e-6f, std::hypot(to.x - from.x, to.y - from.y));
        ImVec2 away_from_it{(to.y - from.y) / length, (from.x - to.x) / length};
        if (away_from_it.x * (third.x - from.x) + away_from_it.y * (third.y - from.y) > 0)
            away_from_it = {-away_from_it.x, -away_from_it.y};
        const ImVec2 label{middle.x + away_from_it.x * unit * 1.2f, middle.y + away_from_it.y * unit * .9f};
        canvas.text(label, {.5f, .5f}, edge.color, fmt::format("{} {}", edge.name, sign_of(edge.side)));
    }
    for (std::size_t i = 0; i < 3; ++i)
        canvas.text(outwards(corner[i], unit * .7f), {.5f, .5f}, palette.text, std::string_view("ABC").substr(i, 1));

    if (far) {
        const ImVec2 target = window.on(canvas, spot);
        const float dx = target.x - center.x, dy = target.y - center.y, length = std::hypot(dx, dy);
        const float reach = std::min(canvas.size().x, canvas.size().y) / 2;
        const auto along = [&](float part) {
            return ImVec2{center.x + dx / length * reach * part, center.y + dy / length * reach * part};
        };
        canvas.arrow(along(.72f), along(.98f), color);
        canvas.text(canvas.at(unit * .4f, unit * .3f), {0, 0}, color, "→ the ray passes far outside");
        return;
    }
    const ImVec2 ray_at = window.on(canvas, spot);
    const float arm = unit * .5f;
    canvas.line({ray_at.x - arm, ray_at.y}, {ray_at.x + arm, ray_at.y}, color, 2);
    canvas.line({ray_at.x, ray_at.y - arm}, {ray_at.x, ray_at.y + arm}, color, 2);
    canvas.dot(ray_at, color, false);
    canvas.text(canvas.at(unit * .4f, unit * .3f), {0, 0}, color, "⊕ the ray");
}

void draw_weights(const Frame& frame, const TriangleTest& test, float width) {
    if (!test.weights) return;
    const auto& [a, b, c] = *test.weights;
    if (!(a.value >= 0 && b.value >= 0 && c.value >= 0)) {
        ImGui::TextWrapped("Not all weights are positive: the point lies outside the triangle.");
        return;
    }
    const float unit = ImGui::GetFontSize();
    const Canvas canvas(frame, {width, unit * 1.5f});
    const Palette& palette = canvas.palette();
    struct Part {
        const char* name;
        double weight;
        ImU32 color;
    };
    double before = 0;
    const auto x = [&](double part) { return static_cast<float>(std::clamp(part, 0.0, 1.0)) * canvas.size().x; };
    for (const Part& part :
         {Part{"A", a.value, palette.a}, Part{"B", b.value, palette.b}, Part{"C", c.value, palette.c}}) {
        const float left = x(before), right = x(before + part.weight);
        before += part.weight;
        canvas.box(canvas.at(left, 0), canvas.at(right, canvas.size().y), part.color);
        const std::string words = fmt::format("{} {:.0f} %", part.name, 100 * part.weight);
        const bool fits = canvas.text_width(words) < right - left;
        if (fits || canvas.text_width(part.name) < right - left)
            canvas.text(canvas.at((left + right) / 2, canvas.size().y / 2), {.5f, .5f},
                        ImGui::GetColorU32(ImGuiCol_WindowBg), fits ? words : part.name);
    }
}

}  // namespace glassbox
