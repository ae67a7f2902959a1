#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "learn/subprocess/subprocess.hpp"
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

/// The learner's files that may be at fault.
struct OwnHeaders {
    std::filesystem::path folder;                      ///< they lie in it, and may include each other
    std::vector<std::filesystem::path> included = {};  ///< by what is compiled; with their folder
};

/// What went wrong in a compilation: of all errors the first that is in one of the learner's files; or the first that
/// a line there has led to; or the first. A file of theirs in which something is not closed goes before what comes
/// after it. `folder` is where the compiler ran. None if the compilation went well. Throws Error if it was the machine
/// that could not do it: its disk is full, or it may not write.
std::optional<CompileError> compile_error(const Outcome& compilation, const OwnHeaders& mine,
                                          const std::filesystem::path& folder);

/// What went wrong when a program was linked. Throws Error in the same way.
std::optional<CompileError> link_error(const Outcome& linking);

/// An error with a learner's headers, told for what it is. Where it is in none of these, `with_ours` compiles the same
/// with our headers: if that fails, too, it is no mistake of the learner's, but one of ours, or Glassbox was built from
/// another source.
CompileError with_its_cause(CompileError error, const std::function<std::optional<CompileError>()>& with_ours);

/// What is wrong with a file of ours, which no header of a learner's is part of: an Error, of one line. `source` is
/// what was to be compiled.
Error error_in_ours(const Outcome& compilation, const std::filesystem::path& source);

/// The line of source with a caret under the column: two printable lines. A tab stays a tab, so that the caret stands
/// right.
std::string with_caret(const CompileError& error);

}  // namespace glassbox::learn
