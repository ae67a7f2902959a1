#pragma once
#include <optional>
#include <stop_token>

#include "viewer/model/state/state.hpp"
#include "viewer/platform/window.hpp"

namespace glassbox {

/// Opens a window, of this size or as large as last time, and shows the state in it until the user closes it, or `stop`
/// is requested, which waits until the settings are kept. Throws Error where there is no display or no OpenGL 3.3.
void view(ViewerState state, std::optional<WindowSize> size, const std::stop_token& stop);

}  // namespace glassbox
