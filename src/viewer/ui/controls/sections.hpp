#pragma once
#include "viewer/ui/panels.hpp"

namespace glassbox {

// The sections of the controls page, one below the other.

void draw_view_controls(const Frame& frame);       ///< the stage, the turns
void draw_shading_controls(const Frame& frame);    ///< the paper's figures, the model, its numbers, the light
void draw_computing_controls(const Frame& frame);  ///< the scalar, the rules
void draw_scene_controls(const Frame& frame);      ///< which scene, and back to what it says

}  // namespace glassbox
