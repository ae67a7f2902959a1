#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "learn/build/compiler.hpp"
#include "learn/course/workspace.hpp"

namespace glassbox::learn {

/// What all of a learner's tests are made with: made once, and again when the compiler or what they are made of
/// changes. It lies in the learner's folder, in .glassbox/tools-….
struct Toolchain {
    Compiler compiler;
    std::vector<std::string> flags;      ///< for each test, those that begin with the precompiled prelude included
    std::filesystem::path main;          ///< the object with main() and the reporter
    std::filesystem::path picture_main;  ///< the object with the main() of a lesson's program
    std::filesystem::path prelude;       ///< what the tests begin with, precompiled
    std::string identity;                ///< what it was made of: a fingerprint
};

/// Whether all of it is there: somebody may have cleaned up.
bool is_there(const Toolchain& tools);

/// The same toolchain, for what strangers wrote: it is compiled and run isolated. Throws Error if that cannot be.
Toolchain isolated(Toolchain tools, const Workspace& workspace);

/// Gets the toolchain, or makes it, which takes some seconds; then `say` is told why it takes long. Throws Error.
Toolchain toolchain(const Workspace& workspace, const std::function<void(const std::string&)>& say);

}  // namespace glassbox::learn
