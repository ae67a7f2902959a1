#include "viewer/model/timeline.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "explain/words.hpp"

namespace glassbox {

std::vector<Event> timeline(const Story& story) {
    std::vector<Event> events;
    for (const story::Surface& surface : story.surfaces) {
        const bool met = surface.fate == story::Fate::nearest || surface.fate == story::Fate::farther;
        events.push_back({fmt::format("surface {} is tested: {}", surface.number, word(surface.fate)), !met, false});
    }
    if (!story.hit) return events;
    for (const story::StoryStep& step : story.hit->steps)
        events.push_back({fmt::format("{} = {}", step.name, step.step.value), false, false});
    return events;
}

std::size_t stepped(std::span<const Event> events, std::size_t now, StepTo to) {
    if (events.empty()) return 0;
    const std::size_t last = events.size() - 1;
    const auto next = [&](bool Event::*wanted) {
        for (std::size_t i = now + 1; i <= last; ++i)
            if (events[i].*wanted) return i;
        return std::min(now, last);
    };
    switch (to) {
        case StepTo::first:
            return 0;
        case StepTo::back:
            return now > 0 ? std::min(now - 1, last) : 0;
        case StepTo::forward:
            return std::min(now + 1, last);
        case StepTo::last:
            return last;
        case StepTo::next_failed:
            return next(&Event::failed);
        case StepTo::next_cancellation:
            return next(&Event::cancellation);
    }
    return now;
}

}  // namespace glassbox
