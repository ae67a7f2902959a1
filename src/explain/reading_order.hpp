#pragma once
#include <span>
#include <vector>

#include "explain/story.hpp"

namespace glassbox {

/// The operations of a tape in the order in which one reads them: operands before results, left ones before right ones,
/// what a call does in one piece. C++ leaves that order open, and compilers differ; the numbers do not depend on it.
/// Changes the order only within a line of source.
std::vector<StepNumber> in_reading_order(std::span<const story::StoryStep> steps, std::span<const Call> calls);

}  // namespace glassbox
