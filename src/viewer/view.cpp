#include "viewer/view.hpp"

#include <algorithm>
#include <utility>

#include "output/output_file.hpp"
#include "viewer/hidden_viewer.hpp"
#include "viewer/model/state/settings.hpp"

namespace glassbox {

namespace {

/// What each step of a script does.
struct Performer {
    HiddenViewer& viewer;

    void operator()(const ChangeState& step) const {
        step.change(viewer.state(), viewer.results());
        viewer.settle();
    }
    void operator()(const PressKey& step) const {
        viewer.frame({}, {&step.press, 1});
        viewer.settle();
    }
    void operator()(const ResizeTo& step) const {
        viewer.resize(step.size);
        viewer.settle();
    }
    void operator()(const Wait& step) const {
        constexpr double frame = 1.0 / 30;
        for (double left = step.seconds; left > 0; left -= frame) viewer.frame({}, {}, std::min(left, frame));
    }
    void operator()(const Screenshot& step) const { write_picture(step.file, viewer.screen().screenshot()); }
};

}  // namespace

void view(ViewerState state, std::optional<WindowSize> size) {
    const std::filesystem::path kept = settings_file();
    const Settings before = read_settings(kept);
    remember(state, before);
    Window window("Glassbox", size.value_or(WindowSize{before.window_width, before.window_height}));
    Interface interface(std::move(state), window.scale(), [] { Window::wake(); });
    const auto draw = [&](const Input& input) {
        const double stands = interface.draw(input);
        if (interface.state().leaving) window.close();
        return stands;
    };
    window.run(draw, [&] { interface.prepare(); });
    const Settings after = settings_of(interface.state(), window.size().width, window.size().height);
    if (!kept.empty() && after != before) write_settings(kept, after);
}

void run_script(ViewerState state, std::span<const ScriptStep> script, WindowSize size) {
    HiddenViewer viewer(std::move(state), size);
    viewer.settle();
    for (const ScriptStep& step : script) std::visit(Performer{viewer}, step);
}

}  // namespace glassbox
