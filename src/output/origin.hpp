#pragma once
#include <string>
#include <utility>
#include <vector>

namespace glassbox {

/// Where a file comes from: a PNG keeps it as text, an EXR as attributes, a PPM as comments.
struct Origin {
    std::string command;  ///< the command line that makes the same bytes again; empty: none does
};

/// The program and its version, and the command: names and what they are, in UTF-8, each on one line. Empty without a
/// command.
std::vector<std::pair<std::string, std::string>> notes_of(const Origin& origin);

}  // namespace glassbox
