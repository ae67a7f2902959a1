#include "viewer/ui/panels.hpp"

namespace glassbox {

void draw_controls(const Frame&) { ImGui::TextUnformatted("controls"); }

}  // namespace glassbox
