#pragma once
#include <span>

#include "viewer/model/state/state.hpp"
#include "viewer/model/work/results.hpp"

namespace glassbox {

/// Returns the steps of the pinned pixel that may be seen: all, or those up to the next question. The learner's own are
/// all seen.
std::span<const Event> steps_shown(const ViewerState& state, const Results& results);

/// Returns the next question; null if nothing is asked any more, or the reader does not want to be asked.
const Question* next_question(const ViewerState& state, const Results& results);

/// The same, once the reader has come to the step where it is asked.
const Question* open_question(const ViewerState& state, const Results& results);

/// Whether that step's loss is hidden: the next question asks for it.
bool hides_loss(const ViewerState& state, const Results& results, std::size_t step);

/// Begins to ask, from the first step and with a new score; or stops.
void set_predicting(ViewerState& state, const Results& results, bool on);

/// Answers the open question, or skips it. Without one, nothing happens.
void answer(ViewerState& state, const Results& results, std::optional<double> said);

/// Begins the questions of another story where there is one: its steps from the first, the score goes on.
void follow_story(ViewerState& state, const Results& results);

/// How many of the answers were right since the questions began.
Score score_so_far(const ViewerState& state);

}  // namespace glassbox
