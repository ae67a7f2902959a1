#include <algorithm>

#include "viewer/ui/widgets/dialog.hpp"

namespace glassbox {

void draw_notice(const Frame& frame) {
    const Notice& notice = frame.state.notice;
    if (notice.text.empty()) return;
    const ImGuiViewport* const viewport = ImGui::GetMainViewport();
    const ImVec2 corner = viewport->WorkPos, all = viewport->WorkSize;
    const float font = ImGui::GetFontSize(), widest = std::min(44 * font, .9f * all.x);
    ImGui::SetNextWindowPos({corner.x + all.x / 2, corner.y + all.y - 2.2f * font}, ImGuiCond_Always, {.5f, 1});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {widest, .9f * all.y});
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_Tooltip | ImGuiWindowFlags_NoDecoration |
                                       ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;
    ImGui::PushStyleColor(ImGuiCol_Border, notice.is_error ? frame.palette.failed : frame.palette.passed);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, std::max(2.f, font / 9));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(.6f * font, .5f * font));
    if (ImGui::Begin("##notice", nullptr, flags)) {
        draw_lines((notice.is_error ? "✗ " : "✓ ") + notice.text, widest - 1.2f * font);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
}

}  // namespace glassbox
