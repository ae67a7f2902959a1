#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "viewer/model/story/stepping.hpp"
#include "viewer/model/story/steps_now.hpp"
#include "viewer/ui/steps/parts.hpp"
#include "viewer/ui/widgets/wrapped.hpp"

namespace glassbox {

namespace {

constexpr std::size_t most_losses = 100;

/// A number of bits, and a bar beneath it, as long as it is of the longest one.
void draw_bits_lost(const Frame& frame, double bits, double most) {
    ImGui::TableNextColumn();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, high = ImGui::GetTextLineHeight();
    const auto part = static_cast<float>(std::clamp(bits / most, 0.0, 1.0));
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + high * .88f}, {at.x + width * part, at.y + high},
                                              frame.palette.warning);
    ImGui::TextUnformatted(bits == 0 ? "none" : fmt::format("{:.1f}", bits).c_str());
}

}  // namespace

void draw_losses(const Frame& frame) {
    const std::vector<RankedLoss> losses = ranked_losses(frame.state, frame.results, most_losses);
    if (losses.empty()) return draw_wrapped(frame.palette.faint_text, "No step lost a bit of its own so far.");
    draw_wrapped(frame.palette.faint_text,
                 "Own: bits lost even from the nearest operands. Inherited: lost as they are further off.");
    ImGui::BeginChild("losses", {0, 0}, true);
    const double most = std::max(losses.front().own, 1.0);
    if (ImGui::BeginTable("losses", 3, ImGuiTableFlags_SizingStretchProp)) {
        ImGui::TableSetupColumn("own", 0, .16f);
        ImGui::TableSetupColumn("inherited", 0, .2f);
        ImGui::TableSetupColumn("step", 0, .64f);
        ImGui::TableHeadersRow();
        for (const auto& [number, own, inherited] : losses) {
            const Event& event = steps_now(frame.state, frame.results).timeline[number];
            ImGui::PushID(static_cast<int>(number));
            ImGui::TableNextRow();
            draw_bits_lost(frame, own, most);
            draw_bits_lost(frame, inherited, most);
            ImGui::TableNextColumn();
            const std::string text = event.group + ": " + (event.formula.empty() ? event.what : event.formula);
            if (ImGui::Selectable(fitting(text, ImGui::GetContentRegionAvail().x).c_str(), number == frame.state.step,
                                  ImGuiSelectableFlags_SpanAllColumns))
                jump(frame.state, frame.results, number);
            if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s\n%s", text.c_str(), event.what.c_str());
            ImGui::PopID();
        }
        ImGui::EndTable();
    }
    ImGui::EndChild();
}

}  // namespace glassbox
