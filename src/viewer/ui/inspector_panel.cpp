#include "explain/text.hpp"
#include "viewer/ui/panels.hpp"

namespace glassbox {

void draw_inspector(const Frame& frame) {
    if (!frame.results.story) {
        ImGui::TextWrapped("Click a pixel of the picture: every number that made it stands here.");
        return;
    }
    ImGui::PushFont(frame.fonts.mono);
    ImGui::TextUnformatted(to_text(*frame.results.story).c_str());
    ImGui::PopFont();
}

}  // namespace glassbox
