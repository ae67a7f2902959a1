#include "viewer/ui/overlay/parts.hpp"

namespace glassbox {

namespace {

void heading(const Frame& frame, const char* text) {
    ImGui::Dummy({0, ImGui::GetFontSize() * .2f});
    ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.accent);
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
    ImGui::Separator();
}

}  // namespace

void draw_overlay(const Frame& frame) {
    // The user looks at a learner's code now, so it comes first.
    const bool mine = shows_mine(frame.state);
    if (mine) {
        heading(frame, "Beside the picture");
        draw_beside(frame);
        heading(frame, "Laid over the picture");
    }
    draw_measurement_list(frame);
    if (!frame.state.overlay.measurement.empty()) {
        draw_minus(frame);
        heading(frame, "What the colours mean");
        draw_legend(frame);
    }
    if (mine) return;
    heading(frame, "Beside the picture");
    draw_beside(frame);
}

}  // namespace glassbox
