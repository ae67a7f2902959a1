#pragma once
#include "viewer/ui/panels.hpp"

namespace glassbox {

/// What the overlay's colours mean, in a corner of the picture; it can be hidden. `corner` and `size` are the picture
/// area's.
void draw_picture_legend(const Frame& frame, ImVec2 corner, ImVec2 size);

}  // namespace glassbox
