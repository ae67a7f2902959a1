#include "viewer/platform/window.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>
#include <utility>

#include "scene/error.hpp"
#include "viewer/platform/context.hpp"

namespace glassbox {
namespace {

constexpr double shortest_frame = 1.0 / 60;  // seconds
constexpr double longest_wait = 3600;
constexpr int frames_to_settle = 3;  // after an event: Dear ImGui lays out with sizes measured in the previous frame

std::string last_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text == nullptr ? "no reason was given" : text;
}

/// GLFW can be used during its lifetime.
struct Library {
    Library() {
        if (glfwInit() == GLFW_TRUE) return;
        throw Error(fmt::format(
            "glassbox view: error: no display was found ({}): use --script or --screenshot, which need none, "
            "or xvfb-run",
            last_error()));
    }
    ~Library() { glfwTerminate(); }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
};

struct Destroy {
    void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};
using Handle = std::unique_ptr<GLFWwindow, Destroy>;

Handle make_window(const std::string& title, WindowSize size) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);  // macOS has no other
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "glassbox");
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "glassbox");
    Handle window(glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr));
    if (window != nullptr) return window;
    throw Error(
        fmt::format("glassbox view: error: this display has no OpenGL 3.3 ({}): try LIBGL_ALWAYS_SOFTWARE=1, or use "
                    "--script or --screenshot",
                    last_error()));
}

/// Dear ImGui's link to GLFW. Install our callbacks first: it calls them from its own.
struct GuiInput {
    explicit GuiInput(GLFWwindow* window) { ImGui_ImplGlfw_InitForOpenGL(window, true); }
    ~GuiInput() { ImGui_ImplGlfw_Shutdown(); }
    GuiInput(const GuiInput&) = delete;
    GuiInput& operator=(const GuiInput&) = delete;
};

/// Our names of the keys that type nothing, and of the space bar.
constexpr std::pair<int, Key> named_keys[] = {
    {GLFW_KEY_LEFT, Key::left},      {GLFW_KEY_RIGHT, Key::right},     {GLFW_KEY_UP, Key::up},
    {GLFW_KEY_DOWN, Key::down},      {GLFW_KEY_ESCAPE, Key::escape},   {GLFW_KEY_ENTER, Key::enter},
    {GLFW_KEY_KP_ENTER, Key::enter}, {GLFW_KEY_SPACE, Key::space},     {GLFW_KEY_HOME, Key::home},
    {GLFW_KEY_END, Key::end},        {GLFW_KEY_PAGE_UP, Key::page_up}, {GLFW_KEY_PAGE_DOWN, Key::page_down},
    {GLFW_KEY_F6, Key::f6},
};

std::optional<Key> named_key(int key) {
    for (const auto& [theirs, ours] : named_keys)
        if (theirs == key) return ours;
    return std::nullopt;
}

char32_t in_lower_case(char32_t c) { return c >= U'A' && c <= U'Z' ? c + (U'a' - U'A') : c; }

/// What a key types in the user's layout, if that is one of the characters of ASCII; otherwise 0.
char32_t typed_by(int key, int scancode) {
    const char* name = glfwGetKeyName(key, scancode);
    const bool is_ascii = name != nullptr && static_cast<unsigned char>(name[0]) < 0x80 && name[1] == '\0';
    return is_ascii ? in_lower_case(static_cast<unsigned char>(name[0])) : 0;
}

/// What the key at this place types on an American keyboard, so that d turns the view and Ctrl+Z undoes in Cyrillic and
/// Greek layouts, too. 0 for a key that types nothing.
char32_t typed_at_place_of(int key) {
    return key > GLFW_KEY_SPACE && key < 0x80 ? in_lower_case(static_cast<char32_t>(key)) : 0;
}

}  // namespace

struct Window::Platform {
    Library library;
    Handle window;
    std::optional<GuiContext> gui;
    std::optional<GuiInput> gui_input;

    std::vector<KeyPress> keys;  // since the last frame
    int modifiers = 0;           // of the key pressed last, whose character comes next
    bool is_by_place = false;    // that key is the last of `keys`, named after its place
    bool stirred = true;         // something happened since the last frame
    std::vector<std::string> dropped;
    double start = 0;

    Platform(const std::string& title, WindowSize size) : window(make_window(title, size)) {
        glfwMakeContextCurrent(window.get());
        glfwSwapInterval(1);
        glfwSetWindowUserPointer(window.get(), this);
        listen();
        gui.emplace();
        gui_input.emplace(window.get());
        start = glfwGetTime();
    }

    static Platform& of(GLFWwindow* window) { return *static_cast<Platform*>(glfwGetWindowUserPointer(window)); }

    void listen() {
        GLFWwindow* w = window.get();
        glfwSetKeyCallback(w, [](GLFWwindow* from, int key, int scancode, int action, int mods) {
            of(from).on_key(key, scancode, action, mods);
        });
        glfwSetCharCallback(w, [](GLFWwindow* from, unsigned character) { of(from).on_character(character); });
        glfwSetDropCallback(w, [](GLFWwindow* from, int count, const char** files) {
            of(from).dropped.assign(files, files + count);
            of(from).stirred = true;
        });
        glfwSetCursorPosCallback(w, [](GLFWwindow* from, double, double) { of(from).stirred = true; });
        glfwSetMouseButtonCallback(w, [](GLFWwindow* from, int, int, int) { of(from).stirred = true; });
        glfwSetScrollCallback(w, [](GLFWwindow* from, double, double) { of(from).stirred = true; });
        glfwSetCursorEnterCallback(w, [](GLFWwindow* from, int) { of(from).stirred = true; });
        glfwSetWindowFocusCallback(w, [](GLFWwindow* from, int) { of(from).stirred = true; });
        glfwSetFramebufferSizeCallback(w, [](GLFWwindow* from, int, int) { of(from).stirred = true; });
        glfwSetWindowRefreshCallback(w, [](GLFWwindow* from) { of(from).stirred = true; });
        glfwSetWindowContentScaleCallback(w, [](GLFWwindow* from, float, float) { of(from).stirred = true; });
    }

    bool shift() const { return (modifiers & GLFW_MOD_SHIFT) != 0; }

    /// Ctrl, or Command; not Ctrl with Alt, which is how Windows reports AltGr.
    bool control() const {
        return (modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) != 0 && (modifiers & GLFW_MOD_ALT) == 0;
    }

    void on_key(int key, int scancode, int action, int mods) {
        stirred = true;
        modifiers = mods;
        is_by_place = false;
        if (action == GLFW_RELEASE) return;
        if (const auto named = named_key(key)) keys.push_back({*named, 0, control(), shift()});
        else if (const char32_t typed = typed_by(key, scancode); typed == 0 && typed_at_place_of(key) != 0) {
            keys.push_back({Key::character, typed_at_place_of(key), control(), shift()});
            is_by_place = true;
        } else if (typed != 0 && control()) keys.push_back({Key::character, typed, true, shift()});
    }

    void on_character(unsigned character) {
        stirred = true;
        if (character <= ' ' || character >= 0x80 || control()) return;
        if (std::exchange(is_by_place, false)) keys.pop_back();  // é on a French keyboard, which types 2 with Shift
        keys.push_back({Key::character, in_lower_case(character), false, shift()});
    }

    bool closing() const { return glfwWindowShouldClose(window.get()) == GLFW_TRUE; }
    bool minimised() const { return glfwGetWindowAttrib(window.get(), GLFW_ICONIFIED) == GLFW_TRUE; }

    /// Processes events: those pending, or, until the time `until`, the next one.
    void take_events(double until) {
        const double wait = std::min(until - glfwGetTime(), longest_wait);
        if (wait <= 0) return glfwPollEvents();
        glfwWaitEventsTimeout(wait);
        if (glfwGetTime() < until) stirred = true;  // perhaps by wake(), which calls no callback
    }

    double draw_frame(const DrawFrame& draw) {
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        const double stands = draw({std::exchange(keys, {}), glfwGetTime() - start, std::exchange(dropped, {})});
        ImGui::Render();
        int width = 0, height = 0;
        glfwGetFramebufferSize(window.get(), &width, &height);
        draw_gui(width, height);
        glfwSwapBuffers(window.get());
        return stands;
    }
};

Window::Window(const std::string& title, WindowSize size) : platform_(std::make_unique<Platform>(title, size)) {}

Window::~Window() = default;

float Window::scale() const {
    // Where a window's coordinates are not pixels (macOS, Wayland), the system scales them itself.
    float content = 1;
    glfwGetWindowContentScale(platform_->window.get(), &content, nullptr);
    int width = 0, pixels = 0;
    glfwGetWindowSize(platform_->window.get(), &width, nullptr);
    glfwGetFramebufferSize(platform_->window.get(), &pixels, nullptr);
    return width > 0 && pixels > 0 ? content * static_cast<float>(width) / static_cast<float>(pixels) : content;
}

WindowSize Window::size() const {
    WindowSize size;
    glfwGetWindowSize(platform_->window.get(), &size.width, &size.height);
    return size;
}

void Window::run(const DrawFrame& draw, const std::function<void()>& prepare) {
    Platform& p = *platform_;
    double drawn_at = glfwGetTime() - shortest_frame, stands_until = 0;
    int unsettled = frames_to_settle;
    while (!p.closing()) {
        // Do not rely on the swap interval: a display without vertical synchronisation takes any number of frames.
        const double early = drawn_at + shortest_frame - glfwGetTime();
        if (early > 0) std::this_thread::sleep_for(std::chrono::duration<double>(early));

        p.take_events(unsettled > 0 ? 0 : stands_until);
        while (p.minimised() && !p.closing()) glfwWaitEventsTimeout(longest_wait);
        if (std::exchange(p.stirred, false)) unsettled = frames_to_settle;

        prepare();
        drawn_at = glfwGetTime();
        stands_until = drawn_at + p.draw_frame(draw);
        if (unsettled > 0) --unsettled;
    }
}

void Window::close() { glfwSetWindowShouldClose(platform_->window.get(), GLFW_TRUE); }

void Window::wake() { glfwPostEmptyEvent(); }

}  // namespace glassbox
