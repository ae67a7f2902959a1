#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace glassbox::learn {

/// What a program that runs isolated has besides the system's own programs and libraries. All else is hidden from it:
/// the home folder, other people's files, the network, other processes, the environment. Its /tmp is its own.
struct Isolation {
    std::vector<std::filesystem::path> reads = {};   ///< files and folders, absolute
    std::vector<std::filesystem::path> writes = {};  ///< folders, absolute; they may lie in those that it reads
};

/// The command line, without the program's own, that runs a program isolated in a folder: that of bubblewrap, `bwrap`,
/// which ends what it runs when it is ended itself. An exit status of 128 and more is that of a signal.
std::vector<std::string> isolating_command(const Isolation& isolation, const std::filesystem::path& folder);

/// The variables of our environment that an isolated program is given, and those that it finds changed.
bool is_for_isolated(std::string_view variable);
std::vector<std::pair<std::string, std::string>> environment_of_isolated();

/// Why programs cannot be run isolated here, and what would help; "" if they can. It is tried.
std::string why_not_isolated();

}  // namespace glassbox::learn
