#pragma once
#include <span>

#include "viewer/platform/offscreen.hpp"
#include "viewer/ui/interface.hpp"

namespace glassbox {

/// The viewer with no display before it: what scripts, tests and the benchmark drive.
class HiddenViewer {
public:
    /// Throws Error where there is no OpenGL 3.3.
    HiddenViewer(ViewerState state, WindowSize size);

    /// Draws a frame, `seconds` after the one before, with the mouse here and these keys just pressed.
    void frame(const Pointer& pointer = {}, std::span<const KeyPress> keys = {}, double seconds = 1.0 / 60);

    /// Draws frames until all is computed and laid out.
    void settle();

    void resize(WindowSize size) { screen_.resize(size); }

    ViewerState& state() { return interface_.state(); }
    const Results& results() const { return interface_.results(); }
    bool settled() const { return interface_.settled(); }
    const Offscreen& screen() const { return screen_; }

private:
    Offscreen screen_;
    Interface interface_;
};

}  // namespace glassbox
