#include <fmt/format.h>

#include "output/value_words.hpp"
#include "viewer/model/overlay/laid_over.hpp"
#include "viewer/model/overlay/subtracted.hpp"
#include "viewer/ui/panels.hpp"
#include "viewer/ui/widgets/wrapped.hpp"

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
    if (const MeasuredChannels* const overlay = laid_over(frame.state, frame.results)) {
        if (overlay->factor > 1) return text + fmt::format("   {}: coarse, 1/{}", overlay->what->name, overlay->factor);
        for (const Channel& channel : overlay->channels)
            text += fmt::format("   {}: {}", channel.name, value_in_words(*overlay->what, channel.at({x, y})));
    } else if (find_measurement(frame.state.overlay.measurement)) {
        text += fmt::format("   {}: … being measured", name_of(frame.state.overlay));
    }
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
    const std::string right = frame.results.progress < 1
                                  ? fmt::format("rendering {:.0f} %", 100 * frame.results.progress)
                                  : fmt::format("{:.4g} × {}", state.view.zoom, frame.results.busy ? "…" : "");
    const float width = ImGui::CalcTextSize(right.c_str()).x, end = ImGui::GetWindowContentRegionMax().x;
    const std::string text = hovered_text(frame);
    ImGui::TextUnformatted(fitting(text, end - width - ImGui::GetCursorPosX() - ImGui::GetFontSize()).c_str());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text.c_str());
    ImGui::SameLine(end - width);
    ImGui::TextUnformatted(right.c_str());
}

}  // namespace glassbox
