#include "viewer/model/story/cursor.hpp"

#include <utility>

#include "viewer/model/story/predicting.hpp"
#include "viewer/model/story/steps_now.hpp"

namespace glassbox {

namespace {

std::optional<std::size_t> surface_of_step(const ViewerState& state, const Results& results) {
    const Steps& steps = steps_now(state, results);
    if (!steps.story) return {};
    const auto events = steps_shown(state, results);
    if (state.step >= events.size()) return {};
    const Event& event = events[state.step];
    const Story& story = *steps.story;
    const std::optional<std::size_t> listed = event.surface ? event.surface
                                              : event.place ? event.place->row
                                                            : std::nullopt;
    if (listed) return story.surfaces[*listed].number;
    // What belongs to no test is done at the hit, or before all of them.
    return event.place && story.hit ? std::optional(story.hit->surface) : std::nullopt;
}

}  // namespace

std::optional<std::size_t> lit_surface(const ViewerState& state, const Results& results) {
    if (state.pointed_surface) return state.pointed_surface;
    return state.page == Page::steps ? surface_of_step(state, results) : std::nullopt;
}

const story::Surface* lit_in_story(const ViewerState& state, const Results& results) {
    const std::optional<std::size_t> lit = lit_surface(state, results);
    if (!lit || !results.story) return nullptr;
    for (const story::Surface& surface : results.story->surfaces)
        if (surface.number == *lit) return &surface;
    return nullptr;
}

void begin_pointing(ViewerState& state) { state.pointed_surface = std::exchange(state.pointing_at, std::nullopt); }

}  // namespace glassbox
