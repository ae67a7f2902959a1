#include <fmt/format.h>

#include "viewer/ui/panels.hpp"

namespace glassbox {

namespace {

std::string hovered_text(const Frame& frame) {
    if (frame.state.keys_work_buttons)
        return "arrows move from button to button, Space presses one, Esc or F6 goes back";
    const Scene& scene = *frame.state.scene;
    if (!frame.state.hovered) return "point at a pixel; click pins it, Shift+click pins another to compare";
    const auto [x, y] = *frame.state.hovered;
    std::string text = fmt::format("pixel ({}, {})   column {}, row {}", x, y, x, scene.height - 1 - y);
    const Picture& picture = frame.results.picture;
    if (picture.image && picture.factor == 1 && picture.image->width == scene.width &&
        picture.image->height == scene.height) {
        const Rgb c = picture.image->at(x, y);
        text += fmt::format("   colour ({}, {}, {})", c.red, c.green, c.blue);
    }
    const auto& overlay = frame.results.overlay;
    if (overlay && overlay->factor == 1)
        for (const Channel& channel : overlay->channels)
            if (channel.width == scene.width && channel.height == scene.height)
                text += fmt::format("   {} = {:.6g} {}", channel.name, channel.at({x, y}), overlay->what->unit);
    return text;
}

}  // namespace

void draw_status(const Frame& frame) {
    const ViewerState& state = frame.state;
    ImGui::AlignTextToFramePadding();
    if (!state.file_error.empty() || !frame.results.error.empty()) {
        const std::string& error = state.file_error.empty() ? frame.results.error : state.file_error;
        ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.failed);
        ImGui::Text("✗ %s", error.c_str());
        ImGui::PopStyleColor();
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", error.c_str());
        return;
    }
    ImGui::TextUnformatted(hovered_text(frame).c_str());
    const std::string right = frame.results.progress < 1
                                  ? fmt::format("rendering {:.0f} %", 100 * frame.results.progress)
                                  : fmt::format("{:.4g} × {}", state.view.zoom, frame.results.busy ? "…" : "");
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(right.c_str()).x);
    ImGui::TextUnformatted(right.c_str());
}

}  // namespace glassbox
