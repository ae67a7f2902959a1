#pragma once
#include <memory>
#include <span>
#include <string>

#include "render/image.hpp"
#include "viewer/platform/input.hpp"
#include "viewer/platform/window.hpp"

namespace glassbox {

/// Like Window, but without a display: an OpenGL context of its own (EGL, surfaceless; elsewhere a hidden window), a
/// Dear ImGui context, and a frame on request. Throws Error if there is no OpenGL 3.3.
class Offscreen {
public:
    explicit Offscreen(WindowSize size);
    ~Offscreen();
    Offscreen(const Offscreen&) = delete;
    Offscreen& operator=(const Offscreen&) = delete;

    WindowSize size() const;
    void resize(WindowSize size);

    /// Draws a frame, `seconds` after the one before, with the mouse here and these keys just pressed. Returns what
    /// `draw` returned.
    double frame(const DrawFrame& draw, const Pointer& pointer = {}, std::span<const KeyPress> keys = {},
                 double seconds = 1.0 / 60);

    /// Returns the last frame as an image.
    Image screenshot() const;

    /// Returns how many messages OpenGL's debug output had since the start, of severity low and above: 0 if all is
    /// well.
    int complaints() const;
    const std::string& last_complaint() const;

private:
    struct Platform;
    std::unique_ptr<Platform> platform_;
};

}  // namespace glassbox
