#pragma once
#include <filesystem>
#include <functional>
#include <variant>

#include "viewer/model/state/state.hpp"
#include "viewer/model/work/results.hpp"
#include "viewer/platform/input.hpp"
#include "viewer/platform/window.hpp"

namespace glassbox::script {

/// Changes the state, as a click or a key would.
struct ChangeState {
    std::function<void(ViewerState&, const Results&)> change;
};
struct PressKey {
    KeyPress press;
};
struct ResizeTo {
    WindowSize size;
};
/// Lets time go by, for what moves by itself.
struct Wait {
    double seconds = 0;
};
struct Screenshot {
    std::filesystem::path file;  ///< a PNG
};

/// What a line of a script does.
using Command = std::variant<ChangeState, PressKey, ResizeTo, Wait, Screenshot>;

/// A command that changes the state: `what(state)`, or `what(state, results)`.
template <class Change>
Command change(const Change& what) {
    return ChangeState{[what](ViewerState& state, const Results& results) {
        if constexpr (std::is_invocable_v<Change, ViewerState&, const Results&>) what(state, results);
        else what(state);
    }};
}

/// A command that changes the setup: undo takes it back.
template <class Change>
Command change_setup(const Change& what) {
    return change([what](ViewerState& state) {
        Setup setup = state.setup.now();
        what(setup);
        state.setup.change(std::move(setup));
    });
}

}  // namespace glassbox::script
