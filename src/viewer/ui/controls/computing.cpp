#include <variant>

#include "render/parameters.hpp"
#include "viewer/ui/controls/sections.hpp"
#include "viewer/ui/widgets/edit.hpp"

namespace glassbox {

namespace {

/// From the smallest triangle to the largest: the tolerance is a volume, whatever the scene's size.
void tolerance(ViewerState& state, double now) {
    const auto set = [&](double value) {
        if (value >= 0 && value <= 1e300)
            drag_setup(state, [&](Setup& setup) { setup.options.triangle_rule = Tolerance{value}; });
    };
    const float font = ImGui::GetFontSize(), gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const double least = 1e-12, most = 1e12;
    ImGui::TextUnformatted("Tolerance, in units of length³");
    const float number = 7 * font;
    ImGui::SetNextItemWidth(std::max(3 * font, ImGui::GetContentRegionAvail().x - number - gap));
    double value = now;
    const bool moved = ImGui::SliderScalar("##slider", ImGuiDataType_Double, &value, &least, &most, "",
                                           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoRoundToFormat);
    const bool again = is_double_clicked();
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) ImGui::SetTooltip("Double click: the paper's");
    if (moved || again) set(again ? Tolerance{}.tolerance : value);
    ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(number);
    value = now;
    if (ImGui::InputDouble("##number", &value, 0, 0, "%.6g")) set(value);
}

}  // namespace

void draw_computing_controls(const Frame& frame) {
    ViewerState& state = frame.state;
    const TriangleRule rule = state.setup.now().options.triangle_rule;
    bool is_first = true;
    for (const Parameter& parameter : parameters()) {
        if (parameter.subject != Subject::computing || !is_offered(parameter)) continue;
        if (!is_first) ImGui::Spacing();
        is_first = false;
        offer_choice(frame, parameter);
        if (!std::holds_alternative<TriangleRule Options::*>(parameter.member)) continue;
        if (const auto* with_number = std::get_if<Tolerance>(&rule)) tolerance(state, with_number->tolerance);
    }
}

}  // namespace glassbox
