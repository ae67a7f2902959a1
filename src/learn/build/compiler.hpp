#pragma once
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "learn/subprocess/subprocess.hpp"

namespace glassbox::learn {

/// A C++ compiler on this machine.
struct Compiler {
    std::string program;   ///< a path, or a name to be found in PATH
    bool clang = false;    ///< clang++, or else g++
    std::string identity;  ///< its version, in its own words: files that one version made are of no use to another
    /// Set to compile and run strangers' code isolated: what it can see besides the files of a compilation.
    std::optional<Isolation> isolation = {};
};

/// Returns the compiler that the environment variable CXX names, or else the one that Glassbox was built with. Throws
/// Error, which says how to get one, if it is missing or does not answer.
Compiler find_compiler();

/// Returns the same compiler, run isolated: besides a compilation's own files it may read these. Throws Error if it
/// then does not answer.
Compiler isolated(Compiler compiler, std::vector<std::filesystem::path> reads);

/// How a file is compiled. Paths are absolute.
struct Compilation {
    std::filesystem::path source;
    std::filesystem::path object;
    std::vector<std::filesystem::path> includes;  ///< searched in this order
    std::vector<std::string> flags;               ///< besides those that all have: C++20, rounding as written
    std::filesystem::path folder;                 ///< where the compiler runs: what lies in it is named from there on
};

/// Compiles a file. The outcome's errors are the compiler's, in English and without colours. Stops a compiler that does
/// not finish, or that needs more memory than the learner's machine can spare.
Outcome compile(const Compiler& compiler, const Compilation& what, const std::stop_token& stop = {});

/// Links objects to a program. `linker` is a flag that chooses one, or "".
Outcome link(const Compiler& compiler, const std::vector<std::filesystem::path>& objects,
             const std::filesystem::path& program, const std::string& linker, const std::stop_token& stop = {});

/// Compiles a header that others include first, so that they need not read it again. Writes the result to `folder`,
/// which must exist. Throws Error if the header cannot be compiled.
void precompile(const Compiler& compiler, const Compilation& header, const std::stop_token& stop = {});

/// Returns the flags that make a compilation start with the header precompiled to this object.
std::vector<std::string> beginning_with(const Compiler& compiler, const std::filesystem::path& precompiled);

/// Returns the folder of doctest.h. Throws Error, which says how to get it, if Glassbox was built without it.
std::filesystem::path doctest_folder();

/// Returns a text that is the same for the same parts, and most likely different for others.
std::string fingerprint(const std::vector<std::string>& parts);

}  // namespace glassbox::learn
