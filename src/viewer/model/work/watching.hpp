#pragma once
#include <cstddef>

#include "viewer/model/state/state.hpp"

namespace glassbox {

/// The place of the paper's loops, `for each column j { for each row i { … } }`, counted from the bottom left.
struct LoopPlace {
    int column = 0, row = 0;
};

/// Where the loops are at their pixel number `k`, from 0, of a picture of this height.
LoopPlace loop_place(std::size_t k, int height);

/// How many pixels the scene's picture has.
double pixels(const ViewerState& state);

/// Begins to fill the picture anew, pixel by pixel.
void watch(ViewerState& state);

/// Goes on for so many seconds; at the last pixel the watching is over.
void go_on_watching(ViewerState& state, double seconds);

}  // namespace glassbox
