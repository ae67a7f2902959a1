#include "viewer/ui/panels.hpp"

namespace glassbox {

void draw_space(const Frame&) { ImGui::TextUnformatted("space"); }

}  // namespace glassbox
