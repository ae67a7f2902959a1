#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "explain/story.hpp"
#include "explain/symbols.hpp"

namespace glassbox {

/// A step of the story: of the test of a listed surface, else of the hit (of the ray's colour in stage 1).
struct StepPlace {
    std::optional<std::size_t> row;  ///< in Story::surfaces
    StepNumber step = 0;
};

/// One thing that happened on the way to a pixel's colour.
struct Event {
    std::string group;          ///< the heading that it stands under: "surface 3, triangle"
    std::string what;           ///< in a line: "8775 = 350 × 25.07", "surface 3 is tested"
    std::string formula;        ///< of a step, in names: "a = D·((B − P) × (C − P))"
    bool has_values = false;    ///< of a formula: Symbol::has_values
    std::optional<bool> holds;  ///< of a test: what it says
    bool failed = false;        ///< a comparison, or the test of a surface, that said no
    bool cancellation = false;  ///< a sum or difference that lost bits beyond those of its operands (is_cancellation)
    std::optional<std::size_t> surface;  ///< in Story::surfaces: whose test begins here, or ends with its answer
    std::optional<StepPlace> place;      ///< if it is a step
    std::optional<StepPlace> serves;     ///< the step that it is done for: the next with a name, or outside vec3.hpp
    std::string left, right;             ///< how a step's operands are written
    std::string_view file, function;     ///< of what is no step: which function of the core does it, if one does
};

/// All events of a pixel's story, in the order in which they happened: the ray; each listed surface's test with its
/// operations and its answer; which surface is nearest; the point, the normal, the light, the bytes.
///
/// No event is listed twice, although the hit's tape begins with the nearest surface's test and computes some parts of
/// it again.
std::vector<Event> timeline(const Story& story);

/// Returns the steps of the tape that a place is on.
std::span<const story::StoryStep> tape_of(const Story& story, const StepPlace& place);

/// Where a step on the timeline can lead.
enum class StepTo { first, back, forward, last, next_failed, next_cancellation };

/// Returns the event that a step leads to from `now`; the same one if there is none.
std::size_t stepped(std::span<const Event> events, std::size_t now, StepTo to);

}  // namespace glassbox
