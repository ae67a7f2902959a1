#pragma once
#include <cstddef>

#include "viewer/model/state/state.hpp"

namespace glassbox {

/// A position in the paper's loops, `for each column j { for each row i { … } }`, counted from the bottom left.
struct LoopPlace {
    int column = 0, row = 0;
};

/// Returns the loops' position at pixel number `k`, from 0, of a picture of this height.
LoopPlace loop_place(std::size_t k, int height);

/// Returns how many pixels the scene's picture has.
double pixels(const ViewerState& state);

/// Starts to fill the picture again, pixel by pixel.
void watch(ViewerState& state);

/// Continues for so many seconds; ends at the last pixel.
void go_on_watching(ViewerState& state, double seconds);

}  // namespace glassbox
