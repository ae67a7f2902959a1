#define EGL_NO_X11  // X11's headers define None, Status, …
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include "scene/error.hpp"
#include "viewer/platform/hidden.hpp"

namespace glassbox {
namespace {

[[noreturn]] void fail(const char* step) {
    throw Error(fmt::format(
        "glassbox view: error: OpenGL 3.3 cannot be had without a display ({} failed with EGL error {:#x}). "
        "Install Mesa's software renderer (Debian, Ubuntu: libegl1 libgl1-mesa-dri)",
        step, static_cast<unsigned>(eglGetError())));
}

/// Returns the surfaceless display, else the system's. Never terminate it: the process has only one of each.
EGLDisplay open_display() {
    for (const EGLDisplay display : {eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr),
                                     eglGetDisplay(EGL_DEFAULT_DISPLAY)})
        if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE) return display;
    fail("eglInitialize");
}

EGLConfig choose_config(EGLDisplay display) {
    constexpr EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    if (eglChooseConfig(display, wanted, &config, 1, &found) != EGL_TRUE || found == 0) fail("eglChooseConfig");
    return config;
}

}  // namespace

HiddenContext::HiddenContext() : display_(open_display()) {
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) fail("eglBindAPI");
    const EGLConfig config = choose_config(display_);
    constexpr EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                                  3,
                                  EGL_CONTEXT_MINOR_VERSION,
                                  3,
                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                  EGL_CONTEXT_OPENGL_DEBUG,
                                  EGL_TRUE,
                                  EGL_NONE};
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
    if (context_ == EGL_NO_CONTEXT) fail("eglCreateContext");
    constexpr EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    surface_ = eglCreatePbufferSurface(display_, config, size);
    make_current();
}

HiddenContext::~HiddenContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroySurface(display_, surface_);
    eglDestroyContext(display_, context_);
}

void HiddenContext::make_current() const {
    if (eglMakeCurrent(display_, surface_, surface_, context_) != EGL_TRUE) fail("eglMakeCurrent");
}

HiddenContext::Function HiddenContext::function(const char* name) { return eglGetProcAddress(name); }

}  // namespace glassbox
