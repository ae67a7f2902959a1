#include "viewer/view.hpp"

#include <utility>

#include "viewer/model/state/settings.hpp"
#include "viewer/ui/interface.hpp"

namespace glassbox {

void view(ViewerState state, std::optional<WindowSize> size) {
    const std::filesystem::path kept = settings_file();
    const Settings before = read_settings(kept);
    remember(state, before);
    remember_recent(state.scene_menu, state.file);
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

}  // namespace glassbox
