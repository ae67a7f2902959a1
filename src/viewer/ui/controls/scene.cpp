#include "viewer/ui/controls/sections.hpp"
#include "viewer/ui/widgets/buttons.hpp"

namespace glassbox {

void draw_scene_controls(const Frame& frame) {
    ViewerState& state = frame.state;
    if (!state.scene->title.empty()) ImGui::TextWrapped("%s", state.scene->title.c_str());
    ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.faint_text);
    ImGui::TextWrapped("%s", state.file.string().c_str());
    ImGui::TextWrapped("Read again whenever the file changes; what you changed here stays.");
    ImGui::PopStyleColor();
    if (ImGui::Button("Open another…")) show_scene_menu(state);
    flow("All as the scene says");
    const Setup own = setup_of(*state.scene);
    if (button_if(!(state.setup.now() == own), "All as the scene says")) state.setup.change(own);
    tip("Takes back all that was changed on this page; undo brings it back");
}

}  // namespace glassbox
