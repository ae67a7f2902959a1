#include <fmt/format.h>

#include "viewer/ui/controls/sections.hpp"
#include "viewer/ui/widgets/buttons.hpp"
#include "viewer/ui/widgets/edit.hpp"
#include "viewer/ui/widgets/slider.hpp"

namespace glassbox {

namespace {

void stages(ViewerState& state) {
    constexpr const char* names[] = {"1 rays", "2 spheres", "3 triangles", "4 shading", "5 turns"};
    ImGui::TextUnformatted("Stage");
    for (int stage = 1; stage <= 5; ++stage) {
        const char* name = names[stage - 1];
        if (stage > 1) flow(name, ImGui::GetStyle().ItemInnerSpacing.x);
        if (toggle(name, state.setup.now().options.stage == stage))
            change_setup(state, [&](Setup& setup) { setup.options.stage = stage; });
    }
}

void step_buttons(ViewerState& state) {
    constexpr struct {
        const char* label;
        const char* what;
        Axis axis;
        double degrees;
    } steps[] = {
        {"a", "turn the view back about z, 10° clockwise", Axis::z, -10},
        {"d", "turn the view 10° counter-clockwise about z", Axis::z, 10},
        {"w", "turn the view 10° counter-clockwise about y", Axis::y, 10},
        {"s", "turn the view back about y, 10° clockwise", Axis::y, -10},
    };
    for (const auto& [label, what, axis, degrees] : steps) {
        const std::string button =
            fmt::format("{}  {} {}10°", label, axis == Axis::z ? 'z' : 'y', degrees < 0 ? "−" : "+");
        if (axis != Axis::z || degrees > 0) flow(button.c_str());
        if (ImGui::Button(button.c_str())) state.setup.change(turned(state.setup.now(), axis, degrees));
        tip(what);
    }
    flow("R  take all back");
    if (button_if(!state.setup.now().options.turns.empty(), "R  take all back"))
        change_setup(state, [](Setup& setup) { setup.options.turns.clear(); });
    tip("as the scene says, without turns");
}

/// A slider for each axis, with the angle of the last turn if that is about it: it sets this one anew, and those of the
/// other axes begin a turn.
void angle_sliders(ViewerState& state) {
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
        const char name = "xyz"[static_cast<int>(axis)];
        double degrees = last_turn(state.setup.now(), axis);
        if (slider(fmt::format("##turn {}", name).c_str(), fmt::format("about {}", name), degrees,
                   {-180, 180, "%+.1f°"}) &&
            degrees >= -1e6 && degrees <= 1e6)
            state.setup.drag(with_last_turn(state.setup.before_drag(), axis, degrees));
        if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
            ImGui::SetTooltip(
                "Drag to turn by any angle; Ctrl+click to type degrees. After a turn about\n"
                "another axis a new one begins here");
    }
}

}  // namespace

void draw_view_controls(const Frame& frame) {
    ViewerState& state = frame.state;
    stages(state);
    ImGui::Spacing();
    if (state.setup.now().options.stage < 5) {
        ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.faint_text);
        ImGui::TextWrapped("Turns are used from stage 5 on.");
        ImGui::PopStyleColor();
    }
    step_buttons(state);
    angle_sliders(state);
    const Options& options = state.setup.now().options;
    ImGui::TextWrapped("Turns so far: %s", turns_in_words(options.turns).c_str());
    if (ImGui::RadioButton("rebuilt", !options.accumulated))
        change_setup(state, [](Setup& setup) { setup.options.accumulated = false; });
    tip("The view is turned once by all turns together, from where the scene has it");
    flow("     accumulated");
    if (ImGui::RadioButton("accumulated", state.setup.now().options.accumulated))
        change_setup(state, [](Setup& setup) { setup.options.accumulated = true; });
    tip("Each turn turns what the one before left, and adds its rounding, as the paper's program does");
    flow("Show the drift");
    if (ImGui::Button("Show the drift")) {
        state.overlay.measurement = "drift";
        state.overlay.range.reset();
    }
    tip("Lay over the picture how far the two are apart");
}

}  // namespace glassbox
