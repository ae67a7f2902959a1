#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace glassbox::learn {

/// What an isolated program can see besides the system's own programs and libraries. Everything else is hidden from it:
/// the home folder, other people's files, the network, other processes, the environment. Its /tmp is its own.
struct Isolation {
    std::vector<std::filesystem::path> reads = {};   ///< files and folders, absolute
    std::vector<std::filesystem::path> writes = {};  ///< folders, absolute; they may lie in those that it reads
};

/// Returns the command line, without the program's own, that runs a program isolated in a folder: that of bubblewrap,
/// `bwrap`, which ends what it runs when it is ended itself. An exit status of 128 or more stands for a signal.
std::vector<std::string> isolating_command(const Isolation& isolation, const std::filesystem::path& folder);

/// Whether an isolated program gets this variable of our environment; and the variables that are changed for it.
bool is_for_isolated(std::string_view variable);
std::vector<std::pair<std::string, std::string>> environment_of_isolated();

/// Returns why programs cannot be run isolated here, and what would help; "" if they can. Tries it.
std::string why_not_isolated();

}  // namespace glassbox::learn
