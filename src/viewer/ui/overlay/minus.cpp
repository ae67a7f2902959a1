#include <algorithm>

#include "viewer/model/overlay/subtracted.hpp"
#include "viewer/ui/overlay/parts.hpp"

namespace glassbox {

namespace {

/// What can be subtracted, each with a line on what it is.
void offer(const Frame& frame, Overlay& overlay, float widest) {
    const float font = ImGui::GetFontSize();
    for (const auto& [name, minus, help] : minus_choices()) {
        if (ImGui::Selectable(name.c_str(), overlay.minus == minus)) subtract(overlay, minus);
        ImGui::Indent(font);
        ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.faint_text);
        ImGui::PushTextWrapPos(widest - font);
        ImGui::TextUnformatted(help.data(), help.data() + help.size());
        ImGui::PopTextWrapPos();
        ImGui::PopStyleColor();
        ImGui::Unindent(font);
    }
}

}  // namespace

void draw_minus(const Frame& frame) {
    Overlay& overlay = frame.state.overlay;
    const std::string present = overlay.minus ? written(*overlay.minus) : "nothing";
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("minus the same by");
    // Beside the words if the choice fits there, with its arrow; else below them.
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    const float needed = ImGui::CalcTextSize(present.c_str()).x + 2.5f * ImGui::GetFrameHeight();
    if (ImGui::GetContentRegionAvail().x < needed) ImGui::NewLine();
    ImGui::SetNextItemWidth(-1);
    const float widest = std::min(34 * ImGui::GetFontSize(), ImGui::GetMainViewport()->WorkSize.x * .9f);
    ImGui::SetNextWindowSizeConstraints({0, 0}, {widest, 1e9f});
    if (ImGui::BeginCombo("##minus", present.c_str())) {
        offer(frame, overlay, widest);
        ImGui::EndCombo();
    }
    if (!overlay.minus) return;
    if (const std::string why = why_not_subtracted(overlay); !why.empty())
        return faint(frame, "Nothing is subtracted: " + why + ".");
    const Setup& now = frame.state.setup.now();
    if (changed_by(*overlay.minus, now) == now)
        faint(frame, "The picture is computed so itself: nothing can differ. Choose another scalar or rule.");
}

}  // namespace glassbox
