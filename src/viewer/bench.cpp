#include "viewer/bench.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "scene/error.hpp"
#include "scene/text_file.hpp"
#include "viewer/hidden_viewer.hpp"

namespace glassbox {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// How long it takes from `begin()`, which must ask for something new, to the end of the frame that shows it: the first
/// one with another of these serial numbers.
template <class Begin>
double time_until_new(HiddenViewer& viewer, std::uint64_t Results::*serial, const Begin& begin) {
    viewer.settle();
    const std::uint64_t before = viewer.results().*serial;
    const auto start = Clock::now();
    begin();
    do viewer.frame();
    while (viewer.results().*serial == before);
    return seconds_since(start);
}

/// Another light: all of the picture must be rendered again.
void move_light(ViewerState& state) {
    Setup setup = state.setup.now();
    setup.light_vector.y += 1;
    state.setup.amend(setup);
}

double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Pins the pixel in the middle.
ViewerState pinned(ViewerState state) {
    pin(state, Pixel{state.scene->width / 2, state.scene->height / 2});
    return state;
}

Turning turn_for_a_while(HiddenViewer& viewer) {
    constexpr double seconds = 3, a_frame = 1.0 / 60;
    viewer.settle();
    Turning result;
    std::vector<double> seen;  // when
    const double before = processor_time();
    const auto start = Clock::now();
    for (int frames = 1; seconds_since(start) < seconds; ++frames) {
        viewer.state().setup.amend(turned(viewer.state().setup.now(), Axis::z, 1));
        const std::uint64_t known = viewer.results().picture_serial;
        viewer.frame();
        if (viewer.results().picture_serial != known) {
            seen.push_back(seconds_since(start));
            ++result.sizes[viewer.results().picture.factor];
        }
        std::this_thread::sleep_until(start + std::chrono::duration<double>(frames * a_frame));
    }
    const double count = std::max<double>(1, static_cast<double>(seen.size()));
    result.pictures = static_cast<double>(seen.size()) / seconds_since(start);
    result.processor = (processor_time() - before) / count;
    std::vector<double> between;
    for (std::size_t i = 1; i < seen.size(); ++i) between.push_back(seen[i] - seen[i - 1]);
    if (between.empty()) between.push_back(seconds);
    result.median = median(between);
    result.least = *std::min_element(between.begin(), between.end());
    result.greatest = *std::max_element(between.begin(), between.end());
    return result;
}

/// Processor time while only the background's threads are there to use any.
double idle_use() {
    constexpr std::chrono::seconds watched{2};
    const double before = processor_time();
    std::this_thread::sleep_for(watched);
    return (processor_time() - before) / watched.count();
}

/// A folder that is gone, with all that is in it, at the end of its life.
struct PassingFolder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("glassbox-bench-" + std::to_string(::getpid()));

    PassingFolder() { std::filesystem::create_directories(path); }
    PassingFolder(const PassingFolder&) = delete;
    PassingFolder& operator=(const PassingFolder&) = delete;
    ~PassingFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
};

}  // namespace

Quickness quickness(ViewerState state, WindowSize size) {
    constexpr int frames = 120, turns = 7;
    HiddenViewer viewer(pinned(std::move(state)), size);
    const Pixel first = *viewer.state().pinned;
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
        // Never the pixel that is pinned already: its story is there.
        const Pixel next{first.x / 2 + i % 2, first.y};
        pinned.push_back(time_until_new(viewer, &Results::story_serial, [&] { pin(viewer.state(), next); }));
        changed.push_back(time_until_new(viewer, &Results::picture_serial, [&] { move_light(viewer.state()); }));
    }
    const Turning turned = turn_for_a_while(viewer);
    viewer.settle();
    return {.frame = median(drawn),
            .slowest_frame = *std::max_element(drawn.begin(), drawn.end()),
            .pin_to_inspector = median(pinned),
            .slider_to_picture = median(changed),
            .turning = turned,
            .idle = idle_use()};
}

Turning turning(ViewerState state, WindowSize size) {
    HiddenViewer viewer(pinned(std::move(state)), size);
    return turn_for_a_while(viewer);
}

std::vector<double> saving_to_picture(ViewerState state, WindowSize size, int edits) {
    using learn::mine::Stand;
    if (!state.mine.chosen) throw Error("view --bench --mine: error: " + state.mine.problem);
    const PassingFolder folder;
    const auto learners = std::make_shared<learn::Workspace>(*state.mine.workspace);
    learners->folder = folder.path;
    state.mine.workspace = learners;
    std::filesystem::path header;
    std::string text;
    for (const learn::Exercise* const exercise : lessons_of(state.mine))
        for (const std::string& name : exercise->headers) {
            header = learners->header(*exercise, name);
            text = read_text(learners->solution(*exercise, name));
            std::filesystem::create_directories(header.parent_path());
            std::ofstream(header) << text;
        }
    show_last_mine(state);
    HiddenViewer viewer(std::move(state), size);
    viewer.settle();

    std::vector<double> seconds;
    for (int i = 0; i < edits; ++i) {
        const auto old = viewer.results().mine;
        const auto start = Clock::now();
        std::ofstream(header) << text << "// edit " << i << '\n';
        const auto is_new = [&] {
            const auto& now = viewer.results().mine;
            return now != old && now->stand != Stand::compiling && now->stand != Stand::drawing;
        };
        while (!is_new()) {
            viewer.frame();
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        seconds.push_back(seconds_since(start));
        const learn::mine::PictureUpdate update = *viewer.results().mine;
        viewer.settle();  // and the tests, if they run
        if (update.stand != Stand::drawn || update.compile_seconds == 0)
            throw Error("view --bench --mine: error: " + update.words);
    }
    return seconds;
}

}  // namespace glassbox
