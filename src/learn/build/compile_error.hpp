#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "learn/build/first_error.hpp"
#include "learn/subprocess/subprocess.hpp"
#include "scene/error.hpp"

namespace glassbox::learn {

/// The learner's files that may be at fault.
struct OwnHeaders {
    std::vector<std::filesystem::path> folders;        ///< they lie in these, and may include each other
    std::vector<std::filesystem::path> included = {};  ///< by what is compiled; with their folder
};

/// Returns what went wrong in a compilation: the first error in one of the learner's files; else the first error that
/// one of their lines led to; else the first error. Something unclosed in a learner's file takes precedence over the
/// errors that follow it. `folder` is where the compiler ran. Returns none if the compilation succeeded. Throws Error
/// if the machine is at fault: its disk is full, or it may not write.
std::optional<CompileError> compile_error(const Outcome& compilation, const OwnHeaders& mine,
                                          const std::filesystem::path& folder);

/// Returns what went wrong when a program was linked. Throws Error in the same cases.
std::optional<CompileError> link_error(const Outcome& linking);

/// Finds the cause of an error with a learner's headers. If the error is in none of them, `with_ours` compiles the same
/// with our headers: if that fails, too, the mistake is not the learner's but ours, or Glassbox was built from other
/// sources.
CompileError with_its_cause(CompileError error, const std::function<std::optional<CompileError>()>& with_ours);

/// Returns an Error, of one line, for a file of ours that includes no header of a learner's. `source` is what was to be
/// compiled.
Error error_in_ours(const Outcome& compilation, const std::filesystem::path& source);

}  // namespace glassbox::learn
