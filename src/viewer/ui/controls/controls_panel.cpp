#include "viewer/ui/controls/sections.hpp"

namespace glassbox {

void draw_controls(const Frame& frame) {
    constexpr struct {
        const char* title;
        void (*draw)(const Frame&);
    } sections[] = {
        {"View", draw_view_controls},
        {"Shading", draw_shading_controls},
        {"Computing", draw_computing_controls},
        {"Scene", draw_scene_controls},
    };
    for (const auto& [title, draw] : sections) {
        if (!ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_DefaultOpen)) continue;
        ImGui::PushID(title);
        draw(frame);
        ImGui::PopID();
        ImGui::Spacing();
    }
}

}  // namespace glassbox
