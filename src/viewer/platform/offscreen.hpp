#pragma once
#include <memory>
#include <span>
#include <string>

#include "render/image.hpp"
#include "viewer/platform/input.hpp"
#include "viewer/platform/window.hpp"

namespace glassbox {

/// The same as Window without a display: an OpenGL context of its own (EGL, surfaceless; elsewhere a hidden window), a
/// Dear ImGui context, and a frame whenever one is asked for. Throws Error where there is no OpenGL 3.3.
class Offscreen {
public:
    explicit Offscreen(WindowSize size);
    ~Offscreen();
    Offscreen(const Offscreen&) = delete;
    Offscreen& operator=(const Offscreen&) = delete;

    WindowSize size() const;
    void resize(WindowSize size);

    /// Draws a frame, `seconds` after the one before, with the mouse here and these keys just pressed. Returns what
    /// `draw` said.
    double frame(const DrawFrame& draw, const Pointer& pointer = {}, std::span<const KeyPress> keys = {},
                 double seconds = 1.0 / 60);

    /// What the last frame looked like.
    Image screenshot() const;

    /// Messages of OpenGL's debug output since the start, of severity low and above: none where all is well.
    int complaints() const;
    const std::string& last_complaint() const;

private:
    struct Platform;
    std::unique_ptr<Platform> platform_;
};

}  // namespace glassbox
