#pragma once
#include "viewer/ui/panels.hpp"

namespace glassbox {

/// Where the watched loops are, on the picture in the area whose corner this is: its column, and its pixel.
void draw_watched_place(const Frame& frame, ImDrawList& list, ImVec2 corner);

}  // namespace glassbox
