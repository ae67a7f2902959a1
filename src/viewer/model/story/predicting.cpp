#include "viewer/model/story/predicting.hpp"

#include "viewer/model/story/steps_now.hpp"

namespace glassbox {

namespace {

void begin_story(ViewerState& state, const Results& results) {
    Predicting& predicting = state.predicting;
    predicting.answers.clear();
    predicting.typed.clear();
    predicting.here = {};
    predicting.story = results.story_serial;
    state.step = 0;
    state.playing = false;
}

Score sum(const Score& a, const Score& b) { return {a.right + b.right, a.of + b.of}; }

}  // namespace

std::span<const Event> steps_shown(const ViewerState& state, const Results& results) {
    const std::span<const Event> all = steps_now(state, results).timeline;
    if (!state.predicting.on || state.mine.is_stepped) return all;
    return all.first(events_seen(all, results.questions, state.predicting.answers.size()));
}

const Question* next_question(const ViewerState& state, const Results& results) {
    const std::size_t next = state.predicting.answers.size();
    return state.predicting.on && !state.mine.is_stepped && next < results.questions.size() ? &results.questions[next]
                                                                                            : nullptr;
}

const Question* open_question(const ViewerState& state, const Results& results) {
    const Question* const next = next_question(state, results);
    return next && state.step == next->at ? next : nullptr;
}

bool hides_loss(const ViewerState& state, const Results& results, std::size_t step) {
    const Question* const next = next_question(state, results);
    return next && next->asked == Asked::bits && next->at == step;
}

void set_predicting(ViewerState& state, const Results& results, bool on) {
    if (state.predicting.on == on) return;
    state.predicting.on = on;
    state.predicting.before = {};
    if (!on) return;
    state.mine.is_stepped = false;  // nothing is asked of the learner's steps
    begin_story(state, results);
}

void answer(ViewerState& state, const Results& results, std::optional<double> said) {
    Predicting& predicting = state.predicting;
    if (!open_question(state, results)) return;
    predicting.answers.push_back(said);
    predicting.typed.clear();
    predicting.here = score(results.timeline, results.questions, predicting.answers);
}

void follow_story(ViewerState& state, const Results& results) {
    Predicting& predicting = state.predicting;
    if (!predicting.on || predicting.story == results.story_serial) return;
    predicting.before = score_so_far(state);
    begin_story(state, results);
}

Score score_so_far(const ViewerState& state) { return sum(state.predicting.before, state.predicting.here); }

}  // namespace glassbox
