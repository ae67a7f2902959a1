#pragma once
#include "viewer/ui/space/labels.hpp"
#include "viewer/ui/space/painter.hpp"

namespace glassbox {

/// How a box's edges are drawn: the style does not rely on colour alone.
struct BoxLine {
    ImU32 color;
    float width;
    bool dashed;
};
BoxLine line_of(const SpaceCanvas& canvas, Passage passage);

/// Draws the buttons that show boxes and choose their level, with the top left corner at `at`. Returns their lower
/// right corner.
ImVec2 draw_box_buttons(const Frame& frame, ImVec2 at);

/// Draws what the lines mean and how many there are, below `top`. Returns where it ends.
float paint_box_legend(const SpaceCanvas& canvas, Labels& labels, float top);

}  // namespace glassbox
