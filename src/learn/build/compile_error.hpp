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

}  // namespace glassbox::learn
