#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "explain/story.hpp"

namespace glassbox {

/// One thing that happened on the way to a pixel's colour.
struct Event {
    std::string what;           ///< in a line: "a = 8775 × 1", "surface 3 is tested"
    bool failed = false;        ///< a test that said no
    bool cancellation = false;  ///< a sum or difference that lost bits beyond those of its operands
};

/// All events of a pixel's story, in the order in which they happened.
std::vector<Event> timeline(const Story& story);

/// Where a step on the timeline can lead.
enum class StepTo { first, back, forward, last, next_failed, next_cancellation };

/// The event that a step leads to from `now`: the same one where there is none.
std::size_t stepped(std::span<const Event> events, std::size_t now, StepTo to);

}  // namespace glassbox
