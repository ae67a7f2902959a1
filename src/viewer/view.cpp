#include "viewer/view.hpp"

#include <chrono>
#include <semaphore>
#include <utility>

#include "render/job.hpp"
#include "viewer/model/state/settings.hpp"
#include "viewer/ui/interface.hpp"

namespace glassbox {

void view(ViewerState state, std::optional<WindowSize> size, const std::stop_token& stop) {
    const std::filesystem::path kept = settings_file();
    const Settings before = read_settings(kept);
    remember(state, before);
    state.pins_at_first = !state.pinned && !state.looked_at;
    remember_recent(state.scene_menu, state.file);
    Window window("Glassbox", size.value_or(WindowSize{before.window_width, before.window_height}));
    Interface interface(std::move(state), window.scale(), [] { Window::wake(); });
    // Whoever requests it may end the program soon after, so hold it up; a window that hangs not for ever.
    std::binary_semaphore kept_settings(0);
    const std::stop_callback close_soon(stop, [&] {
        Window::wake();
        (void)kept_settings.try_acquire_for(std::chrono::seconds(2));
    });
    const auto draw = [&](const Input& input) {
        const double stands = interface.draw(input);
        if (interface.state().leaving || stop.stop_requested()) window.close();
        return stands;
    };
    window.run(draw, [&] { interface.prepare(); });
    const Settings after = settings_of(interface.state(), window.size().width, window.size().height);
    if (!kept.empty() && after != before) write_settings(kept, after);
    kept_settings.release();
    if (stop.stop_requested()) throw Cancelled();
}

}  // namespace glassbox
