#pragma once
#include <string>

#include "scene/error.hpp"

namespace glassbox::learn {

/// Why a program could not be compiled: the one thing to begin with.
struct CompileError {
    Place place;          ///< in the learner's own file, if any error leads there; the file is absolute
    bool yours = false;   ///< whether it is in the learner's own file
    bool ours = false;    ///< whether it is a fault of ours, whatever the learner's file has
    std::string source;   ///< that line of the file
    std::string message;  ///< the compiler's words; empty if it has none that help
    std::string plain;    ///< what they mean and what to do, for the common ones
    int others = 0;       ///< how many more errors there are
};

/// The line of source with a caret under the column: two printable lines. A tab stays a tab, so that the caret stands
/// right.
std::string with_caret(const CompileError& error);

}  // namespace glassbox::learn
