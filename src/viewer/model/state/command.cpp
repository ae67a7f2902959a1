#include "viewer/model/state/command.hpp"

#include <fmt/format.h>

#include <span>
#include <variant>

#include "scene/shell_word.hpp"
#include "viewer/model/overlay/subtracted.hpp"

namespace glassbox {

namespace {

SceneWords words_of(const ViewerState& state) { return words_of(state.file, *state.scene, state.setup.now()); }

/// "--mine=2 --folder ~/rays/my"
std::string options_of_mine(const ViewerState& state) {
    if (!shows_mine(state) || !state.mine.chosen) return "";
    const int* const lesson = std::get_if<int>(&*state.mine.chosen);
    std::string options = lesson ? fmt::format(" --mine={}", *lesson) : " --mine=all";
    if (!state.mine.folder.empty()) options += " --folder " + shell_word(state.mine.folder.string());
    return options;
}

}  // namespace

SceneWords words_of(const std::filesystem::path& file, const Scene& scene, const Setup& setup) {
    return {file, {}, setup, differing(setup, setup_of(scene))};
}

std::string command_to_view(const ViewerState& state) {
    std::string more;
    if (state.pinned) more += fmt::format(" --pixel {},{}", state.pinned->x, state.pinned->y);
    if (!state.overlay.measurement.empty()) more += " --overlay " + state.overlay.measurement;
    if (const Minus* const minus = subtracted(state.overlay)) more += " --minus " + shell_word(written(*minus));
    return view_command(words_of(state), more + options_of_mine(state));
}

std::string command_to_render(const ViewerState& state, std::string_view extension) {
    return command_to_render(state, state.setup.now(), extension);
}

std::string command_to_render(const ViewerState& state, const Setup& setup, std::string_view extension) {
    return render_command(words_of(state.file, *state.scene, setup), extension);
}

std::string command_to_measure(const ViewerState& state, std::string_view extension) {
    const std::string_view what = state.overlay.measurement;
    return measure_command(words_of(state), {{&what, 1}, {}, subtracted(state.overlay)}, extension);
}

std::string command_to_explain(const ViewerState& state, Pixel pixel) {
    return explain_command(words_of(state), pixel);
}

}  // namespace glassbox
