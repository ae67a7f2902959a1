#include <fmt/format.h>

#include "viewer/ui/widgets/dialog.hpp"

namespace glassbox {

void draw_save_menu(const Frame& frame) {
    ViewerState& state = frame.state;
    SaveMenu& menu = state.save_menu;
    if (!menu.shown) return;
    draw_dialog("Save", menu.shown, 36, 0, [&] {
        ImGui::TextWrapped("What is to be saved (↑ ↓)?");
        for (const auto& [what, label] : save_choices(state)) {
            const auto content = [&, &words = label] { ImGui::TextWrapped("%s", words.c_str()); };
            if (draw_row(frame, static_cast<std::size_t>(what), what == menu.what, content)) choose(state, what);
        }
        if (state.overlay.measurement.empty())
            ImGui::TextWrapped("An overlay, once one is laid over the picture, can be saved, too.");
        ImGui::Spacing();
        ImGui::TextWrapped("%s", fmt::format("Its name, in {} or elsewhere", menu.folder.string()).c_str());
        type(menu, typed_text("a name, or a path/to/picture.png", menu.typed, menu.renewed));
        draw_failure(frame, menu.error);
        if (!menu.asked.empty()) {
            ImGui::PushStyleColor(ImGuiCol_Text, frame.palette.warning);
            ImGui::TextWrapped("⚠ %s is there already. Enter once more replaces it; or type another name.",
                               menu.asked.c_str());
            ImGui::PopStyleColor();
        }
        ImGui::Spacing();
        if (ImGui::Button(menu.asked.empty() ? "Save (Enter)" : "Replace it (Enter)")) save(state, frame.results);
        ImGui::SameLine();
        if (ImGui::Button("Cancel (Esc)")) menu.shown = false;
    });
}

}  // namespace glassbox
