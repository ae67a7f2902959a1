#pragma once
#include "viewer/model/story/sources.hpp"
#include "viewer/model/story/timeline.hpp"

namespace glassbox {

/// What the core says about the formula that an event is a part of: a dot product on the way to the side product a
/// gives what is said of `side`. Without text where nothing is said.
Described lesson_of(const Story& story, const Event& event);

/// Where an event is in the core's sources: `line` is from 1, and 0 for what is not on a line.
struct SourceLine {
    const SourceFile* file = nullptr;
    std::size_t line = 0;
};
SourceLine source_of(const Story& story, const Event& event);

}  // namespace glassbox
