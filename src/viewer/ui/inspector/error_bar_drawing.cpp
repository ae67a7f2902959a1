#include <algorithm>

#include "viewer/model/story/error_bar.hpp"
#include "viewer/ui/inspector/drawings.hpp"

namespace glassbox {

namespace {

/// Two slanted strokes: here the line is not to scale.
void draw_break(const Canvas& canvas, float x, float y) {
    const float half = canvas.unit() * .25f;
    canvas.list().AddRectFilled(canvas.at(x - half * .5f, y - half), canvas.at(x + half * .5f, y + half),
                                ImGui::GetColorU32(ImGuiCol_WindowBg));
    for (const float side : {-.5f, .5f})
        canvas.line(canvas.at(x + half * (side - .4f), y + half), canvas.at(x + half * (side + .4f), y - half),
                    canvas.palette().faint_text);
}

}  // namespace

void draw_error_bar(const Frame& frame, const story::Number& number, float width) {
    const ErrorBar bar = error_bar(number);
    const float unit = ImGui::GetFontSize();
    {
        const Canvas canvas(frame, {std::min(width, 14 * unit), unit * 1.05f});
        const Palette& palette = canvas.palette();
        const float y = unit * .5f, half = unit * .3f;
        const auto x = [&](double place) { return static_cast<float>(place) * canvas.size().x; };
        canvas.line(canvas.at(0, y), canvas.at(canvas.size().x, y), palette.line);
        canvas.line(canvas.at(x(zero_on_error_bar), y - half), canvas.at(x(zero_on_error_bar), y + half), palette.text);
        const float label = x(zero_on_error_bar) + unit * .15f;
        canvas.list().AddRectFilled(canvas.at(label, 0), canvas.at(label + canvas.text_width("0"), unit),
                                    ImGui::GetColorU32(ImGuiCol_WindowBg));
        canvas.text(canvas.at(label, y), {0, .5f}, palette.faint_text, "0");
        if (bar.kind == ErrorBar::Kind::magnified)
            draw_break(canvas, (x(zero_on_error_bar) * .45f + x(bar.value) * .55f), y);
        const ImU32 color = bar.sign_is_proven ? palette.passed : palette.failed;
        if (bar.kind != ErrorBar::Kind::exact) {
            const ImU32 pale = (color & ~IM_COL32_A_MASK) | (90u << IM_COL32_A_SHIFT);
            canvas.list().AddRectFilled(canvas.at(x(bar.low), y - half * .7f), canvas.at(x(bar.high), y + half * .7f),
                                        pale);
            for (const double end : {bar.low, bar.high})
                canvas.line(canvas.at(x(end), y - half), canvas.at(x(end), y + half), color, 2);
        }
        canvas.dot(canvas.at(x(bar.value), y), color);
        if (bar.truth) {
            const float at = x(*bar.truth), size = unit * .16f;
            canvas.list().AddQuadFilled(canvas.at(at, y - 2 * size), canvas.at(at + size, y),
                                        canvas.at(at, y + 2 * size), canvas.at(at - size, y), palette.text);
        }
    }
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(
            "From left to right: below 0, 0, above 0.\n"
            "● the computed number, ◆ the true one, the bar: where it is proven to be.%s",
            bar.kind == ErrorBar::Kind::magnified
                ? "\n// the bar is too small to be seen: it is enlarged, apart from 0."
                : "");
    // The words stand beside the line if they fit.
    if (std::min(width, 14 * unit) + unit + ImGui::CalcTextSize(bar.words.c_str()).x <= width) ImGui::SameLine(0, unit);
    ImGui::PushStyleColor(ImGuiCol_Text, bar.sign_is_proven ? frame.palette.faint_text : frame.palette.failed);
    ImGui::TextWrapped("%s", bar.words.c_str());
    ImGui::PopStyleColor();
}

}  // namespace glassbox
