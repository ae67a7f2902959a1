#pragma once
#include <string>
#include <vector>

#include "learn/course/workspace.hpp"

namespace glassbox::learn::mine {

/// Lessons, by number; they belong to a workspace.
using Lessons = std::vector<const Exercise*>;

/// A lesson that is begun, and what it lacks: "`sides`", or "its file sides.hpp".
struct Unfinished {
    const Exercise* exercise;
    std::string waits_for;
};

/// How far a learner has come in the lessons whose headers draw in double.
struct Written {
    Lessons finished;               ///< nothing is left to write in them
    std::vector<Unfinished> begun;  ///< but not finished
    bool is_all = false;            ///< there is no other lesson than those that are finished
};

/// Returns the lessons whose headers draw in double, whether they are begun or not.
Lessons drawing_in_double(const Workspace& workspace);

/// Reads the learner's headers of these lessons, as they are now.
Written written_in(const Workspace& workspace);

/// Says whose functions draw: "drawn by lessons 1, 2 and 4 of yours; lesson 3 waits for `sides`; the rest is ours". If
/// no lesson is finished, says what is to be done.
std::string in_words(const Written& written, const Workspace& workspace);

}  // namespace glassbox::learn::mine
