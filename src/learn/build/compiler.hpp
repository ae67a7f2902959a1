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
    std::string identity;  ///< its version, in its own words: what one version has made is of no use to another
    /// If what strangers wrote is compiled and run: with what, besides the files of a compilation, this is done apart
    /// from all else.
    std::optional<Isolation> isolation = {};
};

/// The compiler that the environment's CXX names, or else the one that Glassbox was built with. Throws Error, which
/// says how to get one, if it is not there or does not answer.
Compiler find_compiler();

/// The same compiler, to be run isolated: by itself it may read these files. Throws Error if it then does not answer.
Compiler isolated(Compiler compiler, std::vector<std::filesystem::path> reads);

/// How a file is compiled. Paths are absolute.
struct Compilation {
    std::filesystem::path source;
    std::filesystem::path object;
    std::vector<std::filesystem::path> includes;  ///< searched in this order
    std::vector<std::string> flags;               ///< besides those that all have: C++20, rounding as written
    std::filesystem::path folder;                 ///< where the compiler runs: what lies in it is named from there on
};

/// Compiles a file. The outcome's errors are the compiler's, in English and without colours. A compiler that does not
/// come to an end is ended, and so is one that needs more memory than the learner's machine can spare.
Outcome compile(const Compiler& compiler, const Compilation& what, const std::stop_token& stop = {});

/// Links objects to a program.
Outcome link(const Compiler& compiler, const std::vector<std::filesystem::path>& objects,
             const std::filesystem::path& program, const std::stop_token& stop = {});

/// Compiles a header that others begin with, so that they need not read it again. The result lies in `folder`, which
/// must be there. Throws Error if it cannot be compiled.
void precompile(const Compiler& compiler, const Compilation& header, const std::stop_token& stop = {});

/// The flags that make a compilation begin with the header that was precompiled to this object.
std::vector<std::string> beginning_with(const Compiler& compiler, const std::filesystem::path& precompiled);

/// The folder of doctest.h. Throws Error, which says how to get it, if Glassbox was built without.
std::filesystem::path doctest_folder();

/// A text that is the same for the same parts, and most likely for no others.
std::string fingerprint(const std::vector<std::string>& parts);

}  // namespace glassbox::learn
