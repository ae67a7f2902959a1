#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/platform/input.hpp"

namespace glassbox {

struct ViewerState;

/// The window *Copy*: the commands that make again what is seen.
struct CopyMenu {
    bool shown = false;
    std::size_t chosen = 0;
};

/// A command of what is seen.
struct CopyRow {
    std::string_view what;  ///< "the picture"
    std::string command;
};

/// Those of the viewer, the picture, the overlay and the pinned pixel, as far as there are any.
std::vector<CopyRow> copy_rows(const ViewerState& state);

void show_copy_menu(ViewerState& state);

/// Puts a text where others can paste it, and says so: "copied: glassbox render room"; or `what` it is, if it is long.
void copy(ViewerState& state, std::string text, std::string_view what = "");

/// Copies the chosen row and closes the window.
void copy_chosen(ViewerState& state);

/// What a key does while the window is shown.
void obey_in_copy_menu(const KeyPress& press, ViewerState& state);

}  // namespace glassbox
