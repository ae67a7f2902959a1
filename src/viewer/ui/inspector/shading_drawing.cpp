#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "explain/phrases.hpp"
#include "viewer/model/story/inspector.hpp"
#include "viewer/ui/inspector/drawings.hpp"

namespace glassbox {

namespace {

using namespace story;

/// Two arrows of length 1, one upright, and the angle between them.
struct Fan {
    const char *product, *upright, *other;
    double cosine;
    ImU32 color;
    bool on_surface;  ///< the upright one is the normal
};

void draw_fan(const Canvas& canvas, const Fan& fan, ImVec2 low, float width, float height) {
    const Palette& palette = canvas.palette();
    const float unit = canvas.unit();
    const bool behind = fan.cosine < 0;
    const float arm = std::min(width * .42f, (height - 4.2f * unit) * (behind ? .6f : 1));
    const ImVec2 foot{low.x + width * .4f, low.y + 1.2f * unit + arm};
    if (fan.on_surface) {
        canvas.line({low.x + unit * .2f, foot.y}, {low.x + width - unit * .4f, foot.y}, palette.line, 2);
        for (float x = low.x + unit * .4f; x < low.x + width - unit * .6f; x += unit * .5f)
            canvas.line({x + unit * .3f, foot.y}, {x, foot.y + unit * .3f}, palette.line);
    }
    const float turn = static_cast<float>(angle(fan.cosine) * std::numbers::pi / 180);
    const ImVec2 tip{foot.x + arm * std::sin(turn), foot.y - arm * std::cos(turn)};
    const float quarter = std::numbers::pi_v<float> / 2;
    canvas.list().PathArcTo(foot, arm * .45f, -quarter, turn - quarter, 32);
    canvas.list().PathStroke(behind ? palette.failed : palette.passed, false, std::max(1.5f, unit / 9));
    canvas.arrow(foot, {foot.x, foot.y - arm}, palette.text);
    canvas.arrow(foot, tip, fan.color);
    canvas.text({foot.x - unit * .3f, foot.y - arm}, {1, 0}, palette.text, fan.upright);
    canvas.text({tip.x + unit * .2f, tip.y - (behind ? 0 : unit * .1f)}, {0, behind ? 0.f : 1.f}, fan.color, fan.other);
    const float words = low.y + height - 2.5f * unit;
    canvas.text({low.x + unit * .2f, words}, {0, 0}, palette.text,
                fmt::format("{} {}", fan.product, degrees(fan.cosine)));
    const bool clipped = behind && fan.color != palette.n_r;  // n·r only says which side is seen
    canvas.text({low.x + unit * .2f, words + unit * 1.15f}, {0, 0}, behind ? palette.failed : palette.faint_text,
                clipped ? "< 0: counts as 0" : "cos " + with_minus(fmt::format("{:.4f}", fan.cosine)));
}

}  // namespace

void draw_angles(const Frame& frame, const Shade& shade, float width) {
    const bool phong = shade.model == ShadingModel::phong;
    const Palette& palette = frame.palette;
    const std::array<Fan, 3> fans{
        Fan{"n·l", "n", "l", shade.n_l.value, palette.n_l, true},
        Fan{"n·r", "n", "r", shade.n_r.value, palette.n_r, true},
        Fan{phong ? "r·m" : "n·h", phong ? "r" : "n", phong ? "m" : "h", shade.highlight.value, palette.n_h, !phong}};
    const float unit = ImGui::GetFontSize();
    const int in_a_row = std::clamp(static_cast<int>(width / (8 * unit)), 1, 3);
    const float wide = std::min(width / static_cast<float>(in_a_row), 12 * unit), high = 9 * unit;
    const int rows = (3 + in_a_row - 1) / in_a_row;
    const Canvas canvas(frame, {width, high * static_cast<float>(rows)});
    for (int i = 0; i < 3; ++i)
        draw_fan(canvas, fans[static_cast<std::size_t>(i)],
                 canvas.at(wide * static_cast<float>(i % in_a_row), high * static_cast<float>(i / in_a_row)), wide,
                 high);
}

void draw_terms(const Frame& frame, const Story& story, const Shade& shade, float width) {
    const bool cut = shade.model == ShadingModel::levental_2014;
    struct Line {
        const char *sign, *name;
        Rgb color;
        std::array<std::string, 3> channels;
    };
    const auto bytes = [](Rgb c) {
        return std::array{std::to_string(c.red), std::to_string(c.green), std::to_string(c.blue)};
    };
    const auto term = [&](const char* sign, const char* name, const Term& t) {
        const Vector& v = t.product;
        return Line{sign, name, t.bytes,
                    cut ? bytes(t.bytes)
                        : std::array{fmt::format("{:.1f}", v.x.value), fmt::format("{:.1f}", v.y.value),
                                     fmt::format("{:.1f}", v.z.value)}};
    };
    const std::array<Line, 4> lines{term("", "ambient", shade.ambient), term("+", "diffuse", shade.diffuse),
                                    term("+", "specular", shade.specular),
                                    Line{"=", "pixel", story.traced, bytes(story.traced)}};
    const float unit = ImGui::GetFontSize(), step = 1.5f * unit;
    float names = 0, column = 0;
    for (const Line& line : lines) {
        names = std::max(names, ImGui::CalcTextSize(line.name).x);
        for (const std::string& channel : line.channels)
            column = std::max(column, ImGui::CalcTextSize(channel.c_str()).x + unit * .6f);
    }
    column = std::max(column, ImGui::CalcTextSize("green").x + unit * .6f);
    const float name_at = 3.2f * unit, numbers_at = name_at + names + unit * .4f;
    // If there is no room beside the names, the numbers go below them.
    const bool below = numbers_at + 3 * column > width;
    const float left = below ? std::max(0.f, std::min(name_at, width - 3 * column)) : numbers_at;
    const float each = below ? 2 * step : step;
    const Canvas canvas(frame, {width, step + 4 * each + unit * .5f});
    const Palette& palette = canvas.palette();
    const auto right_edge = [&](std::size_t i) { return left + column * static_cast<float>(i + 1); };
    constexpr const char* channels[] = {"red", "green", "blue"};
    for (std::size_t i = 0; i < 3; ++i)
        canvas.text(canvas.at(right_edge(i), 0), {1, 0}, palette.faint_text, channels[i]);
    float y = step;
    for (const Line& line : lines) {
        if (*line.sign == '=') {
            canvas.line(canvas.at(unit * .1f, y), canvas.at(std::min(width, right_edge(2)), y), palette.text);
            y += unit * .3f;
        }
        canvas.text(canvas.at(unit * .3f, y), {0, 0}, palette.text, line.sign);
        canvas.box(canvas.at(unit, y), canvas.at(2.8f * unit, y + 1.2f * unit), to_color(line.color));
        canvas.text(canvas.at(name_at, y), {0, 0}, palette.text, line.name);
        for (std::size_t i = 0; i < 3; ++i)
            canvas.text(canvas.at(right_edge(i), y + (below ? step : 0)), {1, 0}, palette.text, line.channels[i]);
        y += each;
    }
}

void draw_bits(const Frame& frame, const Options& options, const FirstHit& hit, float width) {
    if (!hit.worst) return;
    const int digits = digits_of_steps(options);
    const double lost = hit.steps[*hit.worst].checked.bits_lost;
    const double before = std::clamp(lost - hit.worst_loss, 0.0, 1.0 * digits);
    const double kept = std::clamp(digits - lost, 0.0, 1.0 * digits);
    const float unit = ImGui::GetFontSize();
    {
        const Canvas canvas(frame, {width, unit * 1.2f});
        const Palette& palette = canvas.palette();
        const float cell = canvas.size().x / static_cast<float>(digits);
        for (int i = 0; i < digits; ++i) {
            const double middle = i + .5;
            const ImU32 color = middle < kept            ? palette.passed
                                : middle < kept + before ? palette.warning
                                                         : palette.failed;
            const ImVec2 low = canvas.at(static_cast<float>(i) * cell, 0),
                         high = canvas.at(static_cast<float>(i + 1) * cell - std::max(1.f, cell * .15f), unit * 1.1f);
            canvas.list().AddRectFilled(low, high, color);
            if (middle >= kept) canvas.line(low, high, ImGui::GetColorU32(ImGuiCol_WindowBg), 2);
        }
    }
    ImGui::TextWrapped(
        "%s", fmt::format("Of {} bits {:.1f} are right; crossed out: {}{:.1f} lost by this operation.", digits, kept,
                          before > 0 ? fmt::format("{:.1f} lost before, ", before) : "", hit.worst_loss)
                  .c_str());
}

}  // namespace glassbox
