#include "viewer/ui/panels.hpp"

namespace glassbox {

void draw_overlay(const Frame&) { ImGui::TextUnformatted("overlay"); }

}  // namespace glassbox
