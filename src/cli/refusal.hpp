#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace glassbox {

/// What is wrong with a command line that could not be parsed, and what would be right, in a line:
/// "glassbox render: error: --thread is not known; did you mean '--threads'?"
std::string refusal(const CLI::App& program, const CLI::ParseError& error);

}  // namespace glassbox
