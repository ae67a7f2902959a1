#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "viewer/model/state/state.hpp"
#include "viewer/model/story/call_stack.hpp"
#include "viewer/model/work/results.hpp"

namespace glassbox {

// How a reader goes through the steps that may be seen (steps_shown). Each function stops playing; without steps,
// nothing happens.

/// Forgets what belongs to another story, and stops hiding steps when the reader stands on a hidden one.
void follow_steps(ViewerState& state, const Results& results);

/// Goes a step, among those that are not hidden.
void go(ViewerState& state, const Results& results, StepTo to);

/// Goes to an event, and remembers from where.
void jump(ViewerState& state, const Results& results, std::size_t event);

/// Goes to where the reader has jumped from, or forth again.
void jump_back(ViewerState& state, const Results& results);
void jump_forth(ViewerState& state, const Results& results);

/// Jumps to the step that made the present one's first operand, or its second. The scene's numbers are made by none.
void jump_to_operand(ViewerState& state, const Results& results, bool second);

/// Returns which events are shown, as `stepped` takes it: all, or only what feeds one number.
std::vector<bool> events_kept(const ViewerState& state, const Results& results);

/// Shows only what feeds the present step's number, or all steps again.
void show_only_feeding(ViewerState& state, const Results& results, bool on);

/// "Only the 12 steps that feed Δ; 2208 hidden". Empty where none are.
std::string hidden_in_words(const ViewerState& state, const Results& results);

/// Returns which line of the present step's call stack is looked at, from 0, the outermost.
std::size_t level_now(const ViewerState& state, const Results& results);
void look_at_level(ViewerState& state, std::size_t level);

/// Looks into what the line calls; on the innermost line, goes to the next step.
void step_into(ViewerState& state, const Results& results);
/// Goes on until the line is done.
void step_over(ViewerState& state, const Results& results);
/// Goes on until the function is left.
void step_out(ViewerState& state, const Results& results);

/// A step that loses bits of its own.
struct RankedLoss {
    std::size_t event = 0;
    double own = 0, inherited = 0;  ///< bits
};

/// Returns those steps, the greatest own loss first; at most so many. What is to be guessed is left out.
std::vector<RankedLoss> ranked_losses(const ViewerState& state, const Results& results, std::size_t most);

/// Returns the surface whose inputs can be nudged: the one of the nudges that there are, else of the present step, else
/// the one that is hit. None where there is none, or its verdict is to be guessed; nor of the learner's code, as the
/// test is done again by ours.
std::optional<std::size_t> row_to_nudge(const ViewerState& state, const Results& results);

/// Moves one input by so many numbers, further than it is.
void nudge(ViewerState& state, const Results& results, const std::string& input, int by);
void undo_nudge(ViewerState& state, const Results& results);
void reset_nudges(ViewerState& state);

}  // namespace glassbox
