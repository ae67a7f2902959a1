#pragma once

namespace glassbox {

struct ViewerState;
struct Results;

/// Once a scene's picture is there, and as long as nothing has been pinned by hand: pins the pixel nearest to the
/// picture's middle that shows something else than the background, so that there is something to see at once.
void pin_at_first(ViewerState& state, const Results& results);

}  // namespace glassbox
