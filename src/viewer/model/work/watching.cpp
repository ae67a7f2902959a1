#include "viewer/model/work/watching.hpp"

#include <algorithm>

namespace glassbox {

LoopPlace loop_place(std::size_t k, int height) {
    const auto rows = static_cast<std::size_t>(height);
    return {static_cast<int>(k / rows), static_cast<int>(k % rows)};
}

double pixels(const ViewerState& state) { return 1.0 * state.scene->width * state.scene->height; }

void watch(ViewerState& state) {
    state.watching.on = state.watching.running = true;
    state.watching.shown = 0;
}

void go_on_watching(ViewerState& state, double seconds) {
    Watching& watching = state.watching;
    if (!watching.on || !watching.running) return;
    watching.shown = std::min(pixels(state), watching.shown + seconds * watching.pixels_per_second);
    if (watching.shown >= pixels(state)) watching.on = watching.running = false;
}

}  // namespace glassbox
