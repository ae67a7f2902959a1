#pragma once
#include "viewer/ui/panels.hpp"

namespace glassbox {

/// Marks where the watched loops are, on the picture in the area with this corner: the column, and the pixel.
void draw_watched_place(const Frame& frame, ImDrawList& list, ImVec2 corner);

}  // namespace glassbox
