#include "viewer/bench.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <thread>
#include <utility>
#include <vector>

#include "viewer/hidden_viewer.hpp"

namespace glassbox {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// How long it takes from `begin()` to the end of the frame after which `there()` holds.
template <class Begin, class There>
double time_until(HiddenViewer& viewer, const Begin& begin, const There& there) {
    viewer.settle();
    const auto start = Clock::now();
    begin();
    do viewer.frame();
    while (!there());
    return seconds_since(start);
}

/// Another light: all of the picture must be rendered again.
void move_light(ViewerState& state) {
    Setup setup = state.setup.now();
    setup.light_position.y += 1;
    state.setup.amend(setup);
}

/// Processor time while only the background's threads are there to use any.
double idle_use() {
    constexpr std::chrono::seconds watched{2};
    const std::clock_t before = std::clock();
    std::this_thread::sleep_for(watched);
    return static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC / watched.count();
}

}  // namespace

Quickness quickness(ViewerState state, WindowSize size) {
    constexpr int frames = 120, turns = 15;
    const Pixel first{state.scene->width / 2, state.scene->height / 2};
    state.pinned = first;
    HiddenViewer viewer(std::move(state), size);
    viewer.settle();

    std::vector<double> drawn;
    for (int i = 0; i < frames; ++i) {
        if (viewer.settled()) move_light(viewer.state());
        const auto start = Clock::now();
        viewer.frame();
        drawn.push_back(seconds_since(start));
    }

    std::vector<double> pinned, changed;
    for (int i = 0; i < turns; ++i) {
        pinned.push_back(time_until(
            viewer,
            [&] {
                viewer.state().pinned = Pixel{first.x + i % first.x, first.y};
            },
            [&, before = viewer.results().story_serial] { return viewer.results().story_serial != before; }));
        changed.push_back(time_until(
            viewer, [&] { move_light(viewer.state()); },
            [&, before = viewer.results().picture_serial] { return viewer.results().picture_serial != before; }));
    }
    viewer.settle();
    return {median(drawn), *std::max_element(drawn.begin(), drawn.end()), median(pinned), median(changed), idle_use()};
}

}  // namespace glassbox
