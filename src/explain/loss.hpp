#pragma once
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "explain/story.hpp"

namespace glassbox {

/// How many bits an operation lost beyond those that its operands had lost; 0 for inputs, comparisons, and where the
/// operands' loss is not known. `steps` are all steps of its tape.
inline double bits_lost_by(std::span<const story::StoryStep> steps, const story::StoryStep& told) {
    const auto lost = [&](StepNumber operand) { return steps[operand].checked.bits_lost; };
    if (operands(told.step.operation) == 0 || !(told.checked.bits_lost > 0)) return 0;
    const double left = lost(told.step.left), right = lost(told.step.right);
    if (std::isnan(left) || std::isnan(right)) return 0;
    return std::max(0.0, told.checked.bits_lost - std::max(left, right));
}

/// The operations that lose bits of their own, the greatest loss first, equal ones in their order; at most that many.
inline std::vector<StepNumber> worst_losses(std::span<const story::StoryStep> steps, std::size_t most) {
    std::vector<StepNumber> worst;
    for (std::size_t i = 0; i < steps.size(); ++i)
        if (steps[i].checked.own_loss > 0) worst.push_back(static_cast<StepNumber>(i));
    const auto more = [&](StepNumber a, StepNumber b) { return steps[a].checked.own_loss > steps[b].checked.own_loss; };
    std::stable_sort(worst.begin(), worst.end(), more);
    worst.resize(std::min(worst.size(), most));
    return worst;
}

/// The loss, in bits, from which a sum or difference counts as a cancellation: a correctly rounded result of exact
/// operands is off by at most half a unit in the last place, which is log2(1.5) = 0.58 bits.
inline constexpr double cancellation_from = 1;

inline bool is_cancellation(std::span<const story::StoryStep> steps, const story::StoryStep& told) {
    const bool sum = told.step.operation == Operation::add || told.step.operation == Operation::subtract;
    return sum && bits_lost_by(steps, told) >= cancellation_from;
}

}  // namespace glassbox
