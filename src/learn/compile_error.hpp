#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "learn/child.hpp"
#include "scene/error.hpp"

namespace glassbox::learn {

/// Why a program could not be compiled: the one thing to begin with.
struct CompileError {
    Place place;          ///< in the learner's own file, if any error leads there; the file is absolute
    bool yours = false;   ///< whether it is in the learner's own file
    std::string source;   ///< that line of the file
    std::string message;  ///< the compiler's words
    std::string plain;    ///< what they mean and what to do, for the common ones
    int others = 0;       ///< how many more errors there are
};

/// What went wrong in a compilation: of all errors the first that is in one of the learner's files, in the folder
/// `mine`; or the first that a line there has led to; or the first. `folder` is where the compiler ran. None if the
/// compilation went well.
std::optional<CompileError> compile_error(const Outcome& compilation, const std::filesystem::path& mine,
                                          const std::filesystem::path& folder);

/// What went wrong when a program was linked.
std::optional<CompileError> link_error(const Outcome& linking);

/// The line of source with a caret under the column: two lines. A tab stays a tab, so that the caret stands right.
std::string with_caret(const CompileError& error);

}  // namespace glassbox::learn
