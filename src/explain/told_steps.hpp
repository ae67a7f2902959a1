#pragma once
#include <utility>
#include <vector>

#include "explain/story.hpp"
#include "numerics/tape.hpp"

namespace glassbox {

/// A tape's steps with their names and checks; only the first ones, if the tape has grown since `checked`.
inline std::vector<story::StoryStep> told_steps(const Tape& tape, const std::vector<Checked>& checked) {
    std::vector<story::StoryStep> told;
    told.reserve(checked.size());
    std::vector<std::string> names = tape.names();
    for (std::size_t i = 0; i < checked.size(); ++i) told.push_back({tape.steps()[i], std::move(names[i]), checked[i]});
    return told;
}

}  // namespace glassbox
