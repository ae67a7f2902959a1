#pragma once

namespace glassbox {

/// An OpenGL 3.3 core context that draws to nothing that can be seen, with debug output where the system has it. By
/// EGL, which needs no display; where there is no EGL, it belongs to a hidden window. Current once it is made. Throws
/// Error where there is no OpenGL 3.3.
class HiddenContext {
public:
    HiddenContext();
    ~HiddenContext();
    HiddenContext(const HiddenContext&) = delete;
    HiddenContext& operator=(const HiddenContext&) = delete;

    void make_current() const;

    /// One of OpenGL's functions by its name, null if there is none: of those that not every 3.3 has.
    using Function = void (*)();
    static Function function(const char* name);

private:
    void* display_ = nullptr;
    void* surface_ = nullptr;
    void* context_ = nullptr;
};

}  // namespace glassbox
