#include <fmt/format.h>

#include "viewer/model/setup.hpp"
#include "viewer/ui/panels.hpp"

namespace glassbox {

namespace {

void tip(const char* text) {
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

bool toggle(const char* label, bool on) {
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    const bool clicked = ImGui::Button(label);
    if (on) ImGui::PopStyleColor();
    return clicked;
}

void stage_buttons(ViewerState& state) {
    constexpr const char* what[] = {"rays", "+ spheres", "+ triangles", "+ shading", "+ turns"};
    ImGui::TextUnformatted("Stage");
    for (int stage = 1; stage <= 5; ++stage) {
        ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
        if (toggle(fmt::format("{}##stage", stage).c_str(), state.setup.now().options.stage == stage)) {
            Setup setup = state.setup.now();
            setup.options.stage = stage;
            state.setup.change(std::move(setup));
        }
        tip(what[stage - 1]);
    }
}

/// A button that cannot be pressed now is still there, greyed.
bool button_if(bool possible, const char* label) {
    if (!possible) ImGui::BeginDisabled();
    const bool clicked = ImGui::Button(label);
    if (!possible) ImGui::EndDisabled();
    return clicked;
}

}  // namespace

void draw_toolbar(const Frame& frame) {
    ViewerState& state = frame.state;
    stage_buttons(state);
    ImGui::SameLine();
    if (button_if(state.setup.can_undo(), "Undo")) state.setup.undo();
    tip("Ctrl+Z");
    ImGui::SameLine();
    if (button_if(state.setup.can_redo(), "Redo")) state.setup.redo();
    tip("Ctrl+Y");
    ImGui::SameLine();
    if (toggle("Fit", state.fit)) state.fit = true;
    tip("The whole picture, as large as fits (F)");
    ImGui::SameLine();
    if (toggle("Space", state.space_shown)) state.space_shown = !state.space_shown;
    tip("Show or hide the scene in space");
    ImGui::SameLine();
    if (ImGui::Button(state.appearance.dark ? "Light" : "Dark")) state.appearance.dark = !state.appearance.dark;
    tip("Dark or light");
    ImGui::SameLine();
    if (ImGui::Button("A−")) state.appearance.text_size = std::max(least_text_size, state.appearance.text_size - 2);
    tip("Smaller text (Ctrl −)");
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    if (ImGui::Button("A+")) state.appearance.text_size = std::min(greatest_text_size, state.appearance.text_size + 2);
    tip("Larger text, for a projector (Ctrl +)");
    ImGui::SameLine();
    if (toggle("?", state.keys_shown)) state.keys_shown = !state.keys_shown;
    tip("All keys");
    const std::string title = state.scene->title.empty() ? state.file.filename().string() : state.scene->title;
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x > ImGui::CalcTextSize(title.c_str()).x)
        ImGui::TextDisabled("%s", title.c_str());
    else ImGui::NewLine();
}

}  // namespace glassbox
