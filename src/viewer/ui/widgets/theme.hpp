#pragma once
#include <imgui.h>

#include "explain/story.hpp"
#include "viewer/model/state/state.hpp"

namespace glassbox {

/// Colours with a meaning. Colour is never the only sign: there is a symbol or a word, too, such as ✓ and ✗.
struct Palette {
    ImU32 passed, failed;  ///< green and red that the colour-blind can tell apart
    ImU32 warning;         ///< something needs attention
    ImU32 accent, second;  ///< the pinned pixel and its ray; the second pin's
    ImU32 text, faint_text;
    ImU32 canvas;         ///< behind everything
    ImU32 line;           ///< of a grid, a frame
    ImU32 a, b, c;        ///< the three side products and their edges
    ImU32 n_l, n_r, n_h;  ///< the cosines, and the vectors l, r and h; in Phong's model r·m has the place of n·h
    ImU32 keyword, number, string, comment;  ///< of source code, also on the marked line
    ImU32 box;                               ///< a box of the engine's that the pinned ray meets
};

ImU32 color_of(const Palette& palette, story::Mark mark);

/// Sets Dear ImGui's style for this text size in pixels, and returns the colours that go with it.
Palette apply_theme(const Appearance& appearance, float text_size);

}  // namespace glassbox
