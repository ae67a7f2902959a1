#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <variant>

#include "viewer/model/state/state.hpp"
#include "viewer/model/work/results.hpp"
#include "viewer/platform/input.hpp"
#include "viewer/platform/window.hpp"

namespace glassbox {

// What a script does, step by step. Each step sees all that the ones before asked for computed and drawn.

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
using ScriptStep = std::variant<ChangeState, PressKey, ResizeTo, Wait, Screenshot>;

/// Opens a window, of this size or as large as last time, and shows the state in it until the user closes it. Throws
/// Error where there is no display or no OpenGL 3.3.
void view(ViewerState state, std::optional<WindowSize> size);

/// Runs a script in the same interface without a display. Throws Error where there is no OpenGL 3.3, or when a file
/// cannot be written.
void run_script(ViewerState state, std::span<const ScriptStep> script, WindowSize size);

}  // namespace glassbox
