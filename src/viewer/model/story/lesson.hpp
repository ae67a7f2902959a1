#pragma once
#include "explain/timeline.hpp"
#include "viewer/model/story/sources.hpp"

namespace glassbox {

/// Returns what the core says about the formula that an event is part of: for a dot product within the side product a,
/// what it says about `side`. The text is empty where it says nothing.
Described lesson_of(const Story& story, const Event& event);

/// Where an event is in the core's sources: `line` counts from 1, and is 0 for an event that is not on a line.
struct SourceLine {
    const SourceFile* file = nullptr;
    std::size_t line = 0;
};
SourceLine source_of(const Story& story, const Event& event);

}  // namespace glassbox
