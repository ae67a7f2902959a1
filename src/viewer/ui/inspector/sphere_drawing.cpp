#include <algorithm>
#include <cmath>

#include "viewer/ui/inspector/drawings.hpp"

namespace glassbox {

void draw_sphere(const Frame& frame, const Ray<double>& ray, const story::Surface& surface, float width, ImU32 color) {
    const auto& test = std::get<story::SphereTest>(surface.test);
    // Lengths along the line, from its point nearest to the centre, and perpendicular to it, both in radii.
    const double speed = length(ray.D), radius = test.radius;
    const Vec3<double> to_center = test.center - ray.P;
    const double foot = dot(to_center, ray.D) / speed;
    const double away = length(to_center - foot / speed * ray.D) / radius;
    const double start = -foot / radius;
    if (!std::isfinite(away) || !std::isfinite(start)) {
        ImGui::TextWrapped("Its coordinates are not finite: it cannot be drawn.");
        return;
    }
    const float unit = ImGui::GetFontSize();
    const Canvas canvas(frame, {width, std::min(width * .75f, 9.5f * unit)});
    const Palette& palette = canvas.palette();
    const ImVec2 size = canvas.size();
    canvas.list().AddRect(canvas.at(0, 0), canvas.at(size.x, size.y), palette.line);

    // From the circle's bottom to its top, or to the line above; a line farther away is drawn at the edge, with a break
    // in the distance.
    constexpr double farthest = 3;
    const bool far = away > farthest;
    const double shown = std::min(away, farthest), top = std::max(1.0, shown), height = top + 1;
    const float scale = (size.y - 2.8f * unit) / static_cast<float>(height);
    const ImVec2 middle = canvas.at(size.x / 2, 1.6f * unit + static_cast<float>(top) * scale);
    const float line_y = middle.y - static_cast<float>(shown) * scale;
    const auto on_line = [&](double radii) {
        return ImVec2{middle.x + static_cast<float>(std::clamp(radii, -1e4, 1e4)) * scale, line_y};
    };

    canvas.list().AddCircleFilled(middle, scale, to_color(surface.color, 60), 96);
    canvas.list().AddCircle(middle, scale, palette.text, 96, std::max(1.f, unit / 12));
    canvas.dashed(middle, {middle.x, line_y}, palette.faint_text);
    if (middle.y - line_y > unit)
        canvas.text({middle.x + unit * .3f, (middle.y + line_y) / 2}, {0, .5f}, palette.faint_text,
                    far ? "d, not to scale" : "d");
    const ImVec2 rim{middle.x + scale * .7071f, middle.y + scale * .7071f};
    canvas.line(middle, rim, palette.faint_text);
    canvas.text({(middle.x + rim.x) / 2 + unit * .2f, (middle.y + rim.y) / 2}, {0, 1}, palette.faint_text, "r");

    const float left = canvas.at(0, 0).x, right = canvas.at(size.x, 0).x;
    const bool start_in_sight = on_line(start).x > left + unit && on_line(start).x < right - unit;
    const float from = start_in_sight ? on_line(start).x : left;
    if (start_in_sight) {
        canvas.dashed({left, line_y}, on_line(start), color);
        canvas.dot(on_line(start), color);
        canvas.text({on_line(start).x, line_y + unit * .3f}, {.5f, 0}, color, "P");
    }
    if (start_in_sight || start < 0) canvas.arrow({from, line_y}, {right - unit * .3f, line_y}, color);
    else canvas.dashed({left, line_y}, {right, line_y}, color);  // it starts behind the right edge
    if (!start_in_sight && start < 0) canvas.text({left + unit * .4f, line_y + unit * .2f}, {0, 0}, color, "P →");
    if (!start_in_sight && start >= 0)
        canvas.text({right - unit * .4f, line_y + unit * .2f}, {1, 0}, color, "P is behind it →");

    const auto mark = [&](const std::optional<story::Number>& t, const char* name, bool stable) {
        if (!t || !std::isfinite(t->value)) return;
        const ImVec2 at = on_line((t->value * speed - foot) / radius);
        canvas.dot(at, stable ? palette.text : palette.warning, stable);
        if (stable)
            canvas.text({at.x, at.y - unit * .35f}, {name == std::string_view("t₀") ? 1.f : 0.f, 1}, palette.text,
                        name);
    };
    mark(test.textbook.t0, "t₀", false);
    mark(test.textbook.t1, "t₁", false);
    mark(test.stable.t0, "t₀", true);
    mark(test.stable.t1, "t₁", true);
    canvas.text(canvas.at(unit * .4f, size.y - unit * .3f), {0, 1}, palette.text, "● stable");
    canvas.text(canvas.at(size.x - unit * .4f, size.y - unit * .3f), {1, 1}, palette.warning, "○ textbook");
}

}  // namespace glassbox
