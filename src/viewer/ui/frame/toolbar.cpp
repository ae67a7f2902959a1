#include <fmt/format.h>

#include <algorithm>

#include "viewer/model/state/tour.hpp"
#include "viewer/ui/widgets/buttons.hpp"
#include "viewer/ui/widgets/edit.hpp"

namespace glassbox {

namespace {

void stage_buttons(ViewerState& state) {
    constexpr const char* what[] = {"rays", "+ spheres", "+ triangles", "+ shading", "+ turns"};
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Stage");
    for (int stage = 1; stage <= 5; ++stage) {
        const std::string label = fmt::format("{}##stage", stage);
        flow(label.c_str(), ImGui::GetStyle().ItemInnerSpacing.x);
        if (toggle(label.c_str(), state.setup.now().options.stage == stage))
            change_setup(state, [&](Setup& setup) { setup.options.stage = stage; });
        tip(what[stage - 1]);
    }
}

/// Changes the text size, within what can be read.
void resize_text(ViewerState& state, float by) {
    state.appearance.text_size = std::clamp(state.appearance.text_size + by, least_text_size, greatest_text_size);
}

}  // namespace

void draw_toolbar(const Frame& frame) {
    ViewerState& state = frame.state;
    // What does not fit continues in the next line.
    if (ImGui::Button("Open…")) show_scene_menu(state);
    tip("Open another scene (Ctrl+O)");
    flow("Save…");
    if (ImGui::Button("Save…")) show_save_menu(state);
    tip("Save the picture, the overlay or its numbers (Ctrl+S)");
    flow("Copy…");
    if (ImGui::Button("Copy…")) show_copy_menu(state);
    tip("Copy the command that makes this again (Ctrl+Shift+C)");
    flow("Stage1");
    stage_buttons(state);
    flow("Undo");
    if (button_if(state.setup.can_undo(), "Undo")) state.setup.undo();
    tip("Ctrl+Z");
    flow("Redo");
    if (button_if(state.setup.can_redo(), "Redo")) state.setup.redo();
    tip("Ctrl+Y");
    if (can_show_failing(state)) {
        flow("Show it fail");
        if (ImGui::Button("Show it fail")) show_failing(state);
        tip("With the scalar and the rules with which this scene's numbers fail; Ctrl+Z takes it back");
    }
    flow("Fit");
    if (toggle("Fit", state.fit == Fit::as_fits)) state.fit = Fit::as_fits;
    tip("The whole picture, as large as fits (F)");
    flow("Space");
    if (toggle("Space", state.space_shown)) state.space_shown = !state.space_shown;
    tip("Show or hide the scene in space");
    flow("My picture");
    if (toggle("My picture", shows_mine(state))) toggle_mine(state);
    tip("Your own code's picture beside ours (m)");
    flow("Theme");
    if (ImGui::Button("Theme")) state.appearance.dark = !state.appearance.dark;
    tip(state.appearance.dark ? "The interface dark; a click makes it light"
                              : "The interface light; a click makes it dark");
    flow("A−");
    if (ImGui::Button("A−")) resize_text(state, -2);
    tip("Smaller text (Ctrl −)");
    flow("A+", ImGui::GetStyle().ItemInnerSpacing.x);
    if (ImGui::Button("A+")) resize_text(state, 2);
    tip("Larger text, for a projector (Ctrl +)");
    flow("Tour");
    if (toggle("Tour", state.tour.has_value())) state.tour ? leave_tour(state) : begin_tour(state);
    tip("Seven stops: what there is to see");
    flow("?");
    if (toggle("?", state.keys_shown)) state.keys_shown = !state.keys_shown;
    tip("All keys");
    // Show the title only if it needs no line of its own: the controls page has it, too.
    const std::string title = state.scene->title.empty() ? state.file.filename().string() : state.scene->title;
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    const float gap = 2 * ImGui::GetStyle().ItemSpacing.x;
    if (ImGui::GetItemRectMax().x + gap + ImGui::CalcTextSize(title.c_str()).x > right) return;
    ImGui::SameLine(0, gap);
    ImGui::TextDisabled("%s", title.c_str());
}

}  // namespace glassbox
