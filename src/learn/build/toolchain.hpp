#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "learn/build/compiler.hpp"
#include "learn/course/workspace.hpp"

namespace glassbox::learn {

/// What all of a learner's tests are built with: made once, and again when the compiler or its ingredients change. It
/// is in the learner's folder, in .glassbox/tools-….
struct Toolchain {
    Compiler compiler;
    std::vector<std::string> flags;             ///< for each test, to begin with the precompiled prelude included
    std::vector<std::filesystem::path> runner;  ///< objects with main(), the reporter and what tests share
    std::string linker;                         ///< the flag that chooses the fastest; "" for the compiler's own choice
    std::filesystem::path picture_main;         ///< the object with the main() of a lesson's program
    std::filesystem::path prelude;              ///< what the tests begin with, precompiled
    std::string identity;                       ///< what it was made of: a fingerprint
};

/// Whether all of its files exist: somebody may have deleted them.
bool is_there(const Toolchain& tools);

/// Returns the same toolchain for strangers' code, which is compiled and run isolated. Throws Error if that is
/// impossible.
Toolchain isolated(Toolchain tools, const Workspace& workspace);

/// Returns the toolchain. If it must be made, which takes some seconds, tells `say` why it takes long. Throws Error.
Toolchain toolchain(const Workspace& workspace, const std::function<void(const std::string&)>& say);

}  // namespace glassbox::learn
