#include "viewer/ui/panels.hpp"

namespace glassbox {

void draw_steps(const Frame&) { ImGui::TextUnformatted("steps"); }

}  // namespace glassbox
