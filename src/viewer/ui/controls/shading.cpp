#include <fmt/format.h>

#include <algorithm>

#include "render/parameters.hpp"
#include "scene/direction.hpp"
#include "viewer/ui/controls/sections.hpp"
#include "viewer/ui/widgets/buttons.hpp"
#include "viewer/ui/widgets/edit.hpp"
#include "viewer/ui/widgets/slider.hpp"

namespace glassbox {

namespace {

void figure_buttons(ViewerState& state) {
    ImGui::TextUnformatted("The paper's five figures");
    for (const Figure& figure : figures) {
        if (&figure != figures) flow(figure.name);
        const Setup shown = with_figure(state.setup.now(), figure);
        if (toggle(figure.name, shown == state.setup.now())) state.setup.change(shown);
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip(
                "k_a = %g, k_d = %g, k_s = %g, with the paper's model, exponent 15, intensity 1, and\n"
                "its sphere rule, by which a ray that only touches a sphere misses it",
                figure.k_a, figure.k_d, figure.k_s);
    }
}

/// Refuses a light that has no direction.
void aim(ViewerState& state, const Vec3<double>& position) {
    state.light_refused = !why_no_direction(position).empty();
    if (!state.light_refused) drag_setup(state, [&](Setup& setup) { setup.light_vector = position; });
}

void light_direction(const Frame& frame) {
    ViewerState& state = frame.state;
    const Vec3<double> own = state.scene->light_vector, now = state.setup.now().light_vector;
    ImGui::TextUnformatted("Light, from the world's origin");
    double xyz[] = {now.x, now.y, now.z};
    const float button = ImGui::GetFrameHeight(), gap = ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - gap);
    if (ImGui::InputScalarN("##light", ImGuiDataType_Double, xyz, 3, nullptr, nullptr, "%.6g"))
        aim(state, {xyz[0], xyz[1], xyz[2]});
    tip("x, y, z: only the direction counts, but for the paper's model, whose half vector takes L as it is");
    ImGui::SameLine(0, gap);
    if (now == own) ImGui::Dummy({button, button});
    else if (ImGui::Button("↺##light", {button, 0}))
        change_setup(state, [&](Setup& setup) { setup.light_vector = own; });
    if (!(now == own)) tip("as the scene says");
    if (state.light_refused) {
        ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.failed);
        ImGui::TextWrapped("✗ not taken: a light needs a direction, so x, y and z cannot all be 0, nor huge");
        ImGui::PopStyleColor();
    }

    // While one angle is dragged, the other two numbers stay as they were when the drag began: no rounding adds up.
    Pointing angles = pointing(now);
    const Pointing kept = pointing(state.setup.before_drag().light_vector), scenes = pointing(own);
    const auto angle = [&](const char* name, double& value, double most, double scenes_value) {
        const bool moved = slider(fmt::format("##{}", name).c_str(), name, value, {-most, most, "%.1f°"});
        const bool again = is_double_clicked();
        if (again) value = scenes_value;
        if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
            ImGui::SetTooltip("The light keeps its distance. Ctrl+click to type; double click: as the scene says");
        value = std::clamp(value, -most, most);
        return moved || again;
    };
    if (angle("azimuth", angles.azimuth, 180, scenes.azimuth))
        aim(state, vector_of({angles.azimuth, kept.elevation, kept.distance}));
    if (angle("elevation", angles.elevation, 90, scenes.elevation))
        aim(state, vector_of({kept.azimuth, angles.elevation, kept.distance}));
}

}  // namespace

void draw_shading_controls(const Frame& frame) {
    ViewerState& state = frame.state;
    if (state.setup.now().options.stage < 4) {
        ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.faint_text);
        ImGui::TextWrapped("Shading is used from stage 4 on.");
        ImGui::PopStyleColor();
    }
    figure_buttons(state);
    ImGui::Spacing();
    const auto offer_each = [](const auto& offer) {
        for (const Parameter& parameter : parameters())
            if (parameter.subject == Subject::shading) offer(parameter);
    };
    offer_each([&](const Parameter& parameter) { offer_choice(frame, parameter); });
    ImGui::Spacing();
    offer_each([&](const Parameter& parameter) { offer_slider(state, parameter); });
    ImGui::Spacing();
    light_direction(frame);
}

}  // namespace glassbox
