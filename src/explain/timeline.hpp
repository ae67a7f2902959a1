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
    bool failed = false;        ///< went wrong: an answer that is not the true one, a number that is not finite
    bool cancellation = false;  ///< a sum or difference that lost bits beyond those of its operands (is_cancellation)
    std::optional<std::size_t> surface;  ///< in Story::surfaces: whose test begins here, or ends with its answer
    std::optional<StepPlace> place;      ///< if it is a step
    /// Which events made a step's operands; none for the scene's numbers and constants.
    std::optional<std::size_t> left_made_by, right_made_by;
    std::optional<StepPlace> serves;  ///< the step that it is done for: the next with a name, or outside vec3.hpp
    std::string left, right;          ///< how a step's operands are written
    std::optional<StepPlace> stopped_after;  ///< of a program's early end: the step that it did last
    std::string_view file, function;         ///< of what is no step: which function of the core does it, if one does
};

/// All events of a pixel's story, in the order in which they happened: the ray; each listed surface's test with its
/// operations and its answer; which surface is nearest; the point, the normal, the light, the bytes. The operations of
/// a line are in reading order.
///
/// No event is listed twice, although the hit's tape begins with the nearest surface's test and computes some parts of
/// it again.
std::vector<Event> timeline(const Story& story);

/// Returns the steps of the tape that a place is on.
std::span<const story::StoryStep> tape_of(const Story& story, const StepPlace& place);

/// Returns the calls of that tape, from the outermost to the one in which the step is done; none where it is done in
/// none of the core's functions.
std::vector<CallNumber> calls_around(const Story& story, const StepPlace& place);

/// Returns the calls that those numbers are of.
std::span<const Call> calls_of(const Story& story, const StepPlace& place);

/// Whether an event is a test that says no: a condition that does not hold, a surface that is missed.
inline bool says_no(const Event& event) { return event.holds == false; }

/// Where a step on the timeline can lead.
enum class StepTo { first, back, forward, last, next_no, next_failed, next_cancellation };

/// Returns the event that a step leads to from `now`; the same one if there is none. `shown` tells which events count;
/// if it is empty, all do.
std::size_t stepped(std::span<const Event> events, std::size_t now, StepTo to, const std::vector<bool>& shown = {});

/// Returns which events a number comes from: the event that made it, those that made its operands, and so on.
std::vector<bool> feeding(std::span<const Event> events, std::size_t event);

}  // namespace glassbox
