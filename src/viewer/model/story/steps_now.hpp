#pragma once
#include "viewer/model/state/state.hpp"
#include "viewer/model/work/results.hpp"

namespace glassbox {

/// Returns the steps that are gone through: ours, or the learner's.
inline const Steps& steps_now(const ViewerState& state, const Results& results) {
    if (state.mine.is_stepped) return results.mine_steps;
    return results;
}

}  // namespace glassbox
