#pragma once
#include <functional>
#include <memory>
#include <string>

#include "viewer/platform/input.hpp"

namespace glassbox {

/// Draws one frame with Dear ImGui, and returns how long the frame may stay if nothing happens: 0 asks for the next one
/// at once, infinity for none until an event comes.
using DrawFrame = std::function<double(const Input&)>;

struct WindowSize {
    int width = 1280, height = 800;
};

/// A system window, with an OpenGL 3.3 context and a Dear ImGui context, both made by the constructor and current from
/// then on. Throws Error, which says what to do instead, if there is no display or no OpenGL 3.3.
class Window {
public:
    Window(const std::string& title, WindowSize size);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// The display's scale factor.
    float scale() const;
    WindowSize size() const;

    /// Draws until the user closes the window, at most 60 frames a second, and none while nothing happens. Calls
    /// `prepare` before each frame, when fonts may be loaded.
    void run(
        const DrawFrame& draw, const std::function<void()>& prepare = [] {});

    /// Makes run() return after this frame, as if the user had closed the window.
    void close();

    /// Ends a wait for events. May be called from any thread.
    static void wake();

private:
    struct Platform;
    std::unique_ptr<Platform> platform_;
};

}  // namespace glassbox
