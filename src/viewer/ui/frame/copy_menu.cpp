#include <fmt/format.h>

#include "viewer/ui/widgets/dialog.hpp"

namespace glassbox {

void draw_copy_menu(const Frame& frame) {
    ViewerState& state = frame.state;
    CopyMenu& menu = state.copy_menu;
    if (!menu.shown) return;
    draw_dialog("Copy a command", menu.shown, 40, 0, [&] {
        ImGui::TextWrapped("A command that makes it again, to be pasted into a terminal");
        const std::vector<CopyRow> all = copy_rows(state);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const auto content = [&] {
                ImGui::TextWrapped("%s", std::string(all[i].what).c_str());
                ImGui::PushFont(frame.fonts.mono);
                draw_lines(all[i].command, ImGui::GetContentRegionAvail().x);
                ImGui::PopFont();
            };
            if (!draw_row(frame, i, i == menu.chosen, content)) continue;
            menu.chosen = i;
            copy_chosen(state);
        }
        ImGui::TextWrapped("↑ ↓ choose · Enter copies · Esc closes");
    });
}

}  // namespace glassbox
