#pragma once
#include <string>
#include <vector>

#include "explain/timeline.hpp"
#include "viewer/model/story/sources.hpp"

namespace glassbox {

/// A line of a call stack.
struct StackLine {
    CallNumber call = 0;   ///< the call in which the line is executed; 0: the outermost
    std::string function;  ///< whose line it is
    const SourceFile* file = nullptr;
    std::size_t line = 0;  ///< from 1; 0 where only the function is known

    bool operator==(const StackLine&) const = default;
};

/// Returns the lines, of the core or the learner's, on which a step is done, the outermost first, the innermost, which
/// has the operation, last. Each line but the last calls what the next one is in. Missing between them are a function
/// that calls a lambda which it was given, and what a rule calls of its own, such as `Tolerance::accepts`. Empty for
/// what is no step, or is done by no line. Of a program's early end: those of the step that it did last.
///
/// Calls of functions note their line when the tape is recorded. Operators of vectors cannot: their line is read from
/// the text, where the calling function has that operator on one line only.
std::vector<StackLine> call_stack(const Story& story, const Event& event);

/// Returns the text of its line, without the blanks around it; empty where it is not known.
std::string_view code_of(const StackLine& line);

}  // namespace glassbox
