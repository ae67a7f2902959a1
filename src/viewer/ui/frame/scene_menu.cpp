#include <algorithm>
#include <utility>

#include "viewer/ui/widgets/dialog.hpp"

namespace glassbox {

namespace {

void draw_faint(const Frame& frame, bool chosen, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, chosen ? frame.palette.text : frame.palette.faint_text);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
}

/// A scene at a glance: its picture, its name, its title or what is wrong with it.
void draw_scene(const Frame& frame, const SceneRow& row, bool chosen) {
    const float side = std::min(5.4f * ImGui::GetFontSize(), .25f * ImGui::GetContentRegionAvail().x);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy({side, side * thumbnail_height / thumbnail_width});
    if (const Texture* const small = frame.thumbnails.of(row.path)) {
        const float shrunk = side / thumbnail_width;
        const ImVec2 size{shrunk * static_cast<float>(small->width()), shrunk * static_cast<float>(small->height())};
        ImGui::GetWindowDrawList()->AddImage(small->id(), corner, {corner.x + size.x, corner.y + size.y});
    }
    ImGui::SameLine();
    ImGui::BeginGroup();
    ImGui::TextWrapped("%s", row.name.c_str());
    const Thumbnails* const known = frame.results.thumbnails.get();
    const auto found = known ? known->find(row.path) : Thumbnails::const_iterator();
    if (!known || found == known->end()) draw_faint(frame, chosen, "…");
    else if (const std::string& error = found->second.error; !error.empty())
        chosen ? draw_faint(frame, chosen, "✗ " + error) : draw_failure(frame, error);
    else draw_faint(frame, chosen, found->second.title.empty() ? "without a title" : found->second.title);
    ImGui::EndGroup();
}

void draw_list(const Frame& frame, SceneMenu& menu) {
    const std::vector<SceneRow> listed = rows(menu);
    if (listed.empty()) ImGui::TextWrapped("Nothing here has that in its name. Enter opens the path as it is typed.");
    std::string section;
    for (std::size_t i = 0; i < listed.size(); ++i) {
        const SceneRow& row = listed[i];
        if (std::exchange(section, row.section) != row.section) {
            ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.accent);
            ImGui::TextWrapped("%s", row.section.c_str());
            ImGui::PopStyleColor();
        }
        const bool chosen = i == menu.chosen;
        const bool clicked = draw_row(frame, i, chosen, [&] {
            if (row.is_folder) ImGui::TextWrapped("%s", row.name.c_str());
            else draw_scene(frame, row, chosen);
        });
        if (!clicked) continue;
        menu.chosen = i;
        return open_chosen(frame.state);
    }
}

}  // namespace

void draw_scene_menu(const Frame& frame) {
    SceneMenu& menu = frame.state.scene_menu;
    if (!menu.shown) return;
    draw_dialog("Open a scene", menu.shown, 40, 36, [&] {
        type(menu,
             typed_text("a name, or a path/to/scene.toml", menu.typed, menu.renewed, [&] { return completed(menu); }));
        draw_failure(frame, frame.state.file_error);
        const char* const keys = "↑ ↓ choose · Enter opens · Tab completes · Esc closes";
        const float below = wrapped_height(keys) + ImGui::GetStyle().ItemSpacing.y;
        ImGui::BeginChild("scenes", {0, std::max(2 * ImGui::GetFontSize(), ImGui::GetContentRegionAvail().y - below)});
        draw_list(frame, menu);
        ImGui::EndChild();
        ImGui::TextWrapped("%s", keys);
    });
}

}  // namespace glassbox
