#include <algorithm>
#include <array>

#include "viewer/ui/widgets/buttons.hpp"

namespace glassbox {

namespace {

void open_scene(ViewerState& state, const std::filesystem::path& file) {
    open(state, file);
    if (state.file_error.empty()) state.scene_menu.shown = false;
}

void typed_path(const Frame& frame) {
    ViewerState& state = frame.state;
    std::string& typed = state.scene_menu.typed;
    std::array<char, 1024> text{};
    std::copy_n(typed.data(), std::min(typed.size(), text.size() - 1), text.data());
    const char* const button = "Open";
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::TextUnformatted("A scene file of your own");
    ImGui::SetNextItemWidth(std::max(6 * ImGui::GetFontSize(), ImGui::GetContentRegionAvail().x - style.ItemSpacing.x -
                                                                   ImGui::CalcTextSize(button).x -
                                                                   2 * style.FramePadding.x));
    const bool entered = ImGui::InputTextWithHint("##path", "path/to/scene.toml", text.data(), text.size(),
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    typed = text.data();
    ImGui::SameLine();
    if ((button_if(!typed.empty(), button) || entered) && !typed.empty()) open_scene(state, std::string(typed));
    if (state.file_error.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.failed);
    ImGui::TextWrapped("✗ %s", state.file_error.c_str());
    ImGui::PopStyleColor();
}

void shipped_list(const Frame& frame) {
    ViewerState& state = frame.state;
    if (state.scene_menu.scenes.empty()) return;
    ImGui::TextUnformatted("Scenes that come with Glassbox");
    std::filesystem::path chosen;
    for (const auto& [file, title] : state.scene_menu.scenes) {
        if (ImGui::Selectable(file.stem().string().c_str(), file == state.file)) chosen = file;
        ImGui::Indent();
        ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.faint_text);
        ImGui::TextWrapped("%s", title.empty() ? "without a title" : title.c_str());
        ImGui::PopStyleColor();
        ImGui::Unindent();
    }
    if (!chosen.empty()) open_scene(state, chosen);
}

}  // namespace

void draw_scene_menu(const Frame& frame) {
    SceneMenu& menu = frame.state.scene_menu;
    if (!menu.shown) {
        menu.scenes.clear();  // so that they are read again next time
        return;
    }
    if (menu.scenes.empty()) list_scenes(menu);
    const ImGuiViewport* viewport = ImGui::GetMainViewport();
    const float font = ImGui::GetFontSize();
    const ImVec2 corner = viewport->WorkPos, all = viewport->WorkSize;
    ImGui::SetNextWindowPos({corner.x + all.x / 2, corner.y + all.y / 2}, ImGuiCond_Always, {.5f, .5f});
    ImGui::SetNextWindowSize({std::min(36 * font, all.x * .95f), std::min(34 * font, all.y * .9f)});
    constexpr ImGuiWindowFlags flags =
        ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoResize;
    if (ImGui::Begin("Open a scene", &menu.shown, flags)) {
        typed_path(frame);
        ImGui::Spacing();
        shipped_list(frame);
    }
    ImGui::End();
}

}  // namespace glassbox
