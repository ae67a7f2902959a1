#pragma once

namespace glassbox {

/// An OpenGL 3.3 core context without a visible window, with debug output where the system has it. Uses EGL, which
/// needs no display; without EGL it uses a hidden window. It is current after construction. Throws Error if there is no
/// OpenGL 3.3.
class HiddenContext {
public:
    HiddenContext();
    ~HiddenContext();
    HiddenContext(const HiddenContext&) = delete;
    HiddenContext& operator=(const HiddenContext&) = delete;

    void make_current() const;

    /// An OpenGL function, found by its name, null if there is none: for functions that not every 3.3 has.
    using Function = void (*)();
    static Function function(const char* name);

private:
    void* display_ = nullptr;
    void* surface_ = nullptr;
    void* context_ = nullptr;
};

}  // namespace glassbox
