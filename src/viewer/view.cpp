#include "viewer/view.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "output/output_file.hpp"
#include "scene/error.hpp"
#include "viewer/model/settings.hpp"
#include "viewer/platform/offscreen.hpp"
#include "viewer/ui/interface.hpp"

namespace glassbox {

namespace {

/// The interface with no display before it.
class Stage {
public:
    Stage(ViewerState state, WindowSize size) : screen_(size), interface_(std::move(state), 1, [] {}) {}

    /// Draws until all is computed and drawn: at least as often as Dear ImGui needs to lay out what is new.
    void settle() {
        constexpr int frames_to_lay_out = 4;
        for (int quiet = 0; quiet < frames_to_lay_out;) {
            draw(1.0 / 60);
            quiet = interface_.settled() ? quiet + 1 : 0;
            if (quiet == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    }

    void operator()(const ChangeState& step) {
        step.change(interface_.state(), interface_.results());
        settle();
    }
    void operator()(const PressKey& step) {
        draw(1.0 / 60, {&step.press, 1});
        settle();
    }
    void operator()(const ResizeTo& step) {
        screen_.resize(step.size);
        settle();
    }
    void operator()(const Wait& step) {
        for (double left = step.seconds; left > 0; left -= 1.0 / 30) draw(std::min(left, 1.0 / 30));
    }
    void operator()(const Screenshot& step) { write_picture(step.file, screen_.screenshot()); }

private:
    void draw(double seconds, std::span<const KeyPress> keys = {}) {
        interface_.prepare();
        screen_.frame([&](const Input& input) { return interface_.draw(input); }, {}, keys, seconds);
    }

    Offscreen screen_;
    Interface interface_;
};

}  // namespace

void view(ViewerState state, std::optional<WindowSize> size) {
    const std::filesystem::path kept = settings_file();
    const Settings before = read_settings(kept);
    remember(state, before);
    Window window("Glassbox", size.value_or(WindowSize{before.window_width, before.window_height}));
    Interface interface(std::move(state), window.scale(), [] { Window::wake(); });
    window.run([&](const Input& input) { return interface.draw(input); }, [&] { interface.prepare(); });
    const Settings after = settings_of(interface.state(), window.size().width, window.size().height);
    if (!kept.empty() && after != before) write_settings(kept, after);
}

void run_script(ViewerState state, std::span<const ScriptStep> script, WindowSize size) {
    Stage stage(std::move(state), size);
    stage.settle();
    for (const ScriptStep& step : script) std::visit(stage, step);
}

}  // namespace glassbox
