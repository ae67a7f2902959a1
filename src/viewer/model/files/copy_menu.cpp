#include "viewer/model/files/copy_menu.hpp"

#include <algorithm>
#include <utility>

#include "viewer/model/state/command.hpp"
#include "viewer/model/state/state.hpp"

namespace glassbox {

std::vector<CopyRow> copy_rows(const ViewerState& state) {
    std::vector<CopyRow> all{{"what is seen, in the viewer", command_to_view(state)},
                             {"the picture, into a file", command_to_render(state, ".png")}};
    if (!state.overlay.measurement.empty())
        all.push_back({"the overlay, into a file", command_to_measure(state, ".png")});
    if (state.pinned) all.push_back({"the pinned pixel, in words", command_to_explain(state, *state.pinned)});
    return all;
}

void show_copy_menu(ViewerState& state) {
    state.scene_menu.shown = state.save_menu.shown = state.keys_shown = false;
    state.copy_menu = {true, 0};
}

void copy(ViewerState& state, std::string text, std::string_view what) {
    state.notice = done("copied: " + (what.empty() ? text : std::string(what)));
    state.to_copy = std::move(text);
}

void copy_chosen(ViewerState& state) {
    const std::vector<CopyRow> all = copy_rows(state);
    copy(state, all[std::min(state.copy_menu.chosen, all.size() - 1)].command);
    state.copy_menu.shown = false;
}

void obey_in_copy_menu(const KeyPress& press, ViewerState& state) {
    CopyMenu& menu = state.copy_menu;
    const std::size_t last = copy_rows(state).size() - 1;
    if (press.key == Key::escape) menu.shown = false;
    else if (press.key == Key::enter) copy_chosen(state);
    else if (press.key == Key::up) menu.chosen -= menu.chosen > 0;
    else if (press.key == Key::down) menu.chosen = std::min(menu.chosen + 1, last);
}

}  // namespace glassbox
