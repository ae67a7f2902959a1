#include "viewer/ui/steps/watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "viewer/model/work/watching.hpp"
#include "viewer/ui/steps/parts.hpp"

namespace glassbox {

namespace {

/// Returns the next pixel; none when all are shown.
std::optional<LoopPlace> place_now(const ViewerState& state) {
    if (!state.watching.on || state.watching.shown >= pixels(state)) return {};
    return loop_place(static_cast<std::size_t>(state.watching.shown), state.scene->height);
}

std::string loop_text(const ViewerState& state) {
    const Scene& scene = *state.scene;
    const std::optional<LoopPlace> now = place_now(state);
    if (!now) return "all pixels are shown";
    return fmt::format("for j = 0 … {}:  j = {}\n  for i = 0 … {}:  i = {}", scene.width - 1, now->column,
                       scene.height - 1, now->row);
}

}  // namespace

float watch_height(const Frame& frame) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float row = ImGui::GetFrameHeightWithSpacing();
    const float lines = frame.state.watching.on ? row + 2 * ImGui::GetTextLineHeight() + style.ItemSpacing.y : 0;
    return row + lines + 2 * style.ItemSpacing.y + 1;
}

void draw_watch(const Frame& frame) {
    ViewerState& state = frame.state;
    Watching& watching = state.watching;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::Separator();
    if (!watching.on) {
        if (ImGui::Button("Watch it trace")) watch(state);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("Fill the picture pixel by pixel, as the paper's loops do");
    } else {
        if (ImGui::Button(watching.running ? "Pause" : "Go on")) watching.running = !watching.running;
        ImGui::SameLine(0, gap);
        if (ImGui::Button("Again")) watch(state);
        ImGui::SameLine(0, gap);
        if (ImGui::Button("Stop")) watching.on = watching.running = false;
    }
    if (!watching.on) {
        ImGui::SameLine(0, 2 * gap);
        if (ImGui::GetContentRegionAvail().x < 7 * ImGui::GetFontSize()) return ImGui::NewLine();  // until it is on
    }
    ImGui::SetNextItemWidth(-1);
    constexpr double least = 100, most = 1e6;
    ImGui::SliderScalar("##pixels a second", ImGuiDataType_Double, &watching.pixels_per_second, &least, &most,
                        "%.0f pixels/s", ImGuiSliderFlags_Logarithmic);
    watching.pixels_per_second = std::clamp(watching.pixels_per_second, least, most);
    if (!watching.on) return;
    ImGui::PushFont(frame.fonts.mono);
    ImGui::TextUnformatted(loop_text(state).c_str());
    ImGui::PopFont();
}

void draw_watched_place(const Frame& frame, ImDrawList& list, ImVec2 corner) {
    const ViewerState& state = frame.state;
    const std::optional<LoopPlace> now = place_now(state);
    if (!now) return;
    const Scene& scene = *state.scene;
    const auto at = [&](double x, double y) {
        const Point p = state.view.on_screen({x, y});
        return ImVec2{corner.x + static_cast<float>(p.x), corner.y + static_cast<float>(p.y)};
    };
    const double x = now->column, y = scene.height - 1 - now->row;
    const float r = std::max(ImGui::GetFontSize() / 3, static_cast<float>(state.view.zoom) / 2 + 2);
    const ImVec2 middle = at(x + .5, y + .5);
    list.AddLine(at(x + .5, 0), at(x + .5, scene.height), frame.palette.line, 1);
    list.AddRect({middle.x - r - 1, middle.y - r - 1}, {middle.x + r + 1, middle.y + r + 1}, IM_COL32(0, 0, 0, 255),
                 0.f, 0, 3.f);
    list.AddRect({middle.x - r, middle.y - r}, {middle.x + r, middle.y + r}, frame.palette.warning, 0.f, 0, 2.f);
    const std::string text = fmt::format("j = {}, i = {}", now->column, now->row);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    // On whichever side there is room.
    const float right = corner.x + static_cast<float>(state.area.x);
    const float left = middle.x + 2 * r + size.x < right ? middle.x + 2 * r : middle.x - 2 * r - size.x;
    const float top = std::clamp(middle.y - size.y / 2, corner.y, corner.y + static_cast<float>(state.area.y) - size.y);
    const float pad = ImGui::GetFontSize() / 5;
    list.AddRectFilled({left - pad, top}, {left + size.x + pad, top + size.y}, IM_COL32(0, 0, 0, 200), pad);
    list.AddText({left, top}, IM_COL32_WHITE, text.c_str());
}

}  // namespace glassbox
