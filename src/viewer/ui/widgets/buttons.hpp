#pragma once
#include "viewer/ui/panels.hpp"

namespace glassbox {

/// A tooltip for the previous item.
inline void tip(const char* text) {
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

/// A button that shows whether something is on.
inline bool toggle(const char* label, bool on) {
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    const bool clicked = ImGui::Button(label);
    if (on) ImGui::PopStyleColor();
    return clicked;
}

/// A button that is greyed out while it cannot be pressed.
inline bool button_if(bool possible, const char* label) {
    if (!possible) ImGui::BeginDisabled();
    const bool clicked = ImGui::Button(label);
    if (!possible) ImGui::EndDisabled();
    return clicked;
}

/// Puts the next item, a button with that label, on the same line if there is room, else on the next one.
inline void flow(const char* label, float spacing = -1) {
    const ImGuiStyle& style = ImGui::GetStyle();
    if (spacing < 0) spacing = style.ItemSpacing.x;
    const float width = ImGui::CalcTextSize(label, nullptr, true).x + 2 * style.FramePadding.x;
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (ImGui::GetItemRectMax().x + spacing + width <= right) ImGui::SameLine(0, spacing);
}

}  // namespace glassbox
