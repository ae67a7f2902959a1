#pragma once
#include <chrono>
#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "output/folder.hpp"

namespace glassbox::test {

using Arguments = std::vector<std::string>;

/// The outcome of a run of the program.
struct Ran {
    int status = -1;  ///< its exit status; 128 and the signal's number, as in a shell, if a signal ended it
    std::string out, err;
    double seconds = 0;  ///< from its start, or from the signal that it was sent, to its end
};

/// The folder, streams and environment that the program runs with.
struct Surroundings {
    std::filesystem::path folder;                          ///< it runs there
    const char* in = "/dev/null";                          ///< its stdin; null: closed
    const char* out = "";                                  ///< its stdout; "": captured; null: closed
    const char* err = "";                                  ///< its stderr, likewise
    bool empty_environment = false;                        ///< not even HOME
    std::optional<std::chrono::milliseconds> signal_at{};  ///< sends it `signal` that long after its start
    int signal = SIGINT;
};

/// Runs the program that was built.
Ran run_glassbox(const Arguments& arguments, const Surroundings& surroundings);

/// Writes a file for the program to read.
std::filesystem::path write(const std::filesystem::path& path, const std::string& content);

/// Checks that the program refuses: with that exit status, nothing on stdout, and on stderr one line that contains all
/// these parts; and that its folder is unchanged.
void check_refused(const Folder& folder, const Arguments& arguments, int status, const std::vector<std::string>& parts);

}  // namespace glassbox::test
