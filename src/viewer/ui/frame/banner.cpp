#include <algorithm>

#include "viewer/ui/panels.hpp"

namespace glassbox {

void draw_file_error(const Frame& frame, ImVec2 corner, ImVec2 size) {
    ViewerState& state = frame.state;
    if (state.file_error.empty()) return;
    const float font = ImGui::GetFontSize(), pad = font / 2, button = ImGui::GetFrameHeight();
    const std::string text = "✗ " + state.file_error + "\nThe last good picture is shown.";
    const float room = std::max(4 * font, size.x - 4 * pad - button);
    const ImVec2 extent = ImGui::CalcTextSize(text.c_str(), nullptr, false, room);
    const ImVec2 from{corner.x + pad / 2, corner.y + pad / 2};
    const ImVec2 to{corner.x + size.x - pad / 2, from.y + std::max(extent.y, button) + 2 * pad};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_PopupBg), pad / 2);
    list.AddRect(from, to, frame.palette.failed, pad / 2, 0, std::max(2.f, font / 9));
    list.AddText(ImGui::GetFont(), font, {from.x + pad, from.y + pad}, frame.palette.text, text.c_str(), nullptr, room);
    ImGui::SetCursorScreenPos({to.x - pad - button, from.y + pad});
    if (ImGui::Button("×##file_error", {button, button})) state.file_error.clear();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Hide this until the file changes again");
}

}  // namespace glassbox
