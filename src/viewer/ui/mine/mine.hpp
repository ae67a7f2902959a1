#pragma once
#include <string>

#include "viewer/ui/panels.hpp"

namespace glassbox {

/// The state of the learner's picture, as a sign and a colour.
struct MineSign {
    const char* sign;
    ImU32 color;
};
MineSign mine_sign(const Frame& frame);

/// The same in words, of any number of lines; "" if the picture says everything.
std::string mine_words(const Frame& frame);

/// "mine: 2-spheres"
std::string mine_title(const ViewerState& state);

/// Whether the picture beside ours is an earlier one, and not one of the code as it is now.
bool mine_is_old(const Frame& frame);

/// Draws the words over the lower part of the picture area, from `left` to its right edge.
void draw_mine_banner(const Frame& frame, ImVec2 corner, ImVec2 size, float left);

/// The lessons to choose from.
void draw_lesson_choice(const Frame& frame);

/// The test whose ray is the scene, what it expected and what it got; nothing without one. For a page, and over the
/// upper part of the picture area.
void draw_looked_at(const Frame& frame);
void draw_looked_at_banner(const Frame& frame, ImVec2 corner, ImVec2 size);

/// The state of the picture, which lessons draw it, and what the code printed.
void draw_mine_state(const Frame& frame);

/// How the recording of the learner's steps stands, if there is anything to say.
void draw_recording(const Frame& frame);

}  // namespace glassbox
