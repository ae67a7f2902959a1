#include "viewer/platform/offscreen.hpp"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <string>
#include <vector>

#include "viewer/platform/context.hpp"
#include "viewer/platform/fed_input.hpp"
#include "viewer/platform/hidden.hpp"
#include "viewer/platform/opengl.hpp"

#if defined(GL_DEBUG_OUTPUT) && !defined(__APPLE__)
#define GLASSBOX_DEBUG_OUTPUT
#endif

namespace glassbox {
namespace {

/// The messages of OpenGL's debug output.
struct Complaints {
    int count = 0;
    std::string last;
};

#ifdef GLASSBOX_DEBUG_OUTPUT
void APIENTRY on_message(GLenum, GLenum, GLuint, GLenum severity, GLsizei, const GLchar* text, const void* complaints) {
    if (severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
    auto& all = *static_cast<Complaints*>(const_cast<void*>(complaints));
    ++all.count;
    all.last = text;
}
#endif

/// Whether OpenGL will report to `complaints` from now on; if not, only glGetError reports errors.
bool listen([[maybe_unused]] Complaints& complaints) {
#ifdef GLASSBOX_DEBUG_OUTPUT
    const auto set_callback =
        reinterpret_cast<PFNGLDEBUGMESSAGECALLBACKPROC>(HiddenContext::function("glDebugMessageCallback"));
    const auto choose =
        reinterpret_cast<PFNGLDEBUGMESSAGECONTROLPROC>(HiddenContext::function("glDebugMessageControl"));
    GLint flags = 0;
    glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    if (!set_callback || !choose || !(flags & GL_CONTEXT_FLAG_DEBUG_BIT)) return false;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    choose(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);  // those of low severity are off by default
    set_callback(on_message, &complaints);
    return true;
#else
    return false;
#endif
}

}  // namespace

struct Offscreen::Platform {
    HiddenContext opengl;
    Complaints complaints;
    bool told = listen(complaints);
    GuiContext gui;
    FedInput input;
    GLuint framebuffer = 0, pixels = 0;
    WindowSize size;
    double time = 0;

    Platform() {
        glGenFramebuffers(1, &framebuffer);
        glGenRenderbuffers(1, &pixels);
    }

    ~Platform() {
        make_current();
        glDeleteFramebuffers(1, &framebuffer);
        glDeleteRenderbuffers(1, &pixels);
    }

    Platform(const Platform&) = delete;
    Platform& operator=(const Platform&) = delete;

    void make_current() const {
        opengl.make_current();
        gui.make_current();
    }

    void resize(WindowSize wanted) {
        size = wanted;
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glBindRenderbuffer(GL_RENDERBUFFER, pixels);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size.width, size.height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixels);
        draw_nothing();
    }

    void draw_nothing() const {
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }

    void count_errors() {
        while (!told && glGetError() != GL_NO_ERROR) {
            ++complaints.count;
            complaints.last = "glGetError";
        }
    }
};

Offscreen::Offscreen(WindowSize size) : platform_(std::make_unique<Platform>()) { resize(size); }

Offscreen::~Offscreen() = default;

WindowSize Offscreen::size() const { return platform_->size; }

void Offscreen::resize(WindowSize size) {
    platform_->make_current();
    platform_->resize({std::max(size.width, 1), std::max(size.height, 1)});
}

double Offscreen::frame(const DrawFrame& draw, const Pointer& pointer, std::span<const KeyPress> keys, double seconds) {
    Platform& p = *platform_;
    p.make_current();
    p.time += seconds;
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(p.size.width), static_cast<float>(p.size.height)};
    io.DeltaTime = std::max(static_cast<float>(seconds), FLT_MIN);

    ImGui_ImplOpenGL3_NewFrame();
    p.input.feed(pointer, keys);
    ImGui::NewFrame();
    const double stands = draw({{keys.begin(), keys.end()}, p.time});
    ImGui::Render();
    glBindFramebuffer(GL_FRAMEBUFFER, p.framebuffer);
    draw_gui(p.size.width, p.size.height);
    glFinish();  // as swapping a window's buffers does: otherwise unseen frames pile up, and take no time
    p.count_errors();
    return stands;
}

Image Offscreen::screenshot() const {
    platform_->make_current();
    const auto [width, height] = platform_->size;
    std::vector<Rgb> upwards(pixel_count(width, height));
    static_assert(sizeof(Rgb) == 3);
    glBindFramebuffer(GL_FRAMEBUFFER, platform_->framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, upwards.data());

    Image image(width, height);  // OpenGL's first row is the lowest
    for (int y = 0; y < height; ++y)
        std::copy_n(upwards.begin() + std::ptrdiff_t{height - 1 - y} * width, width, &image.at(0, y));
    return image;
}

int Offscreen::complaints() const { return platform_->complaints.count; }

const std::string& Offscreen::last_complaint() const { return platform_->complaints.last; }

}  // namespace glassbox
