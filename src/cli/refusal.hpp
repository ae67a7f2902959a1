#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace glassbox {

/// One line that says what is wrong with a command line that could not be parsed, and what would be right: "glassbox
/// render: error: --thread is not known; did you mean '--threads'?"
std::string refusal(const CLI::App& program, const CLI::ParseError& error);

}  // namespace glassbox
