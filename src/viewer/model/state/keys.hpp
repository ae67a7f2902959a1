#pragma once
#include <span>
#include <string_view>

#include "viewer/model/state/state.hpp"
#include "viewer/model/work/results.hpp"
#include "viewer/platform/input.hpp"

namespace glassbox {

/// A key and what it does. The list that `?` shows is the list that is used.
struct KeyBinding {
    KeyPress press;
    std::string_view label;  ///< as it is written on the key: "Ctrl+Z"
    std::string_view what;   ///< in a few words: "undo the last change"
    std::string_view group;  ///< the heading that it stands under
    void (*act)(ViewerState&, const Results&, const KeyPress&);
    /// When it means that, before all else that it may mean; null: always.
    bool (*when)(const ViewerState&, const Results&) = nullptr;
};

std::span<const KeyBinding> key_bindings();

/// Whether a window is shown that has the keyboard: what is typed is meant for it, whether or not its field has the
/// focus.
bool takes_keyboard(const ViewerState& state);

/// Does what the key means, if it means anything. While the keyboard works buttons, keys that move from one to the next
/// or press it mean nothing here.
void obey(const KeyPress& press, ViewerState& state, const Results& results);

/// Whether the key means the same while a text is typed.
bool is_obeyed_while_typing(const KeyPress& press);

}  // namespace glassbox
