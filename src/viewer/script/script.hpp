#pragma once
#include <span>
#include <string>
#include <vector>

#include "viewer/script/command.hpp"

namespace glassbox::script {

/// Reads a script's text: one command per line, quotes around words with blanks, # begins a comment (docs/viewer.md).
/// Throws Error with the file's name and the line for an invalid command; a command may throw one, too, when it is run.
std::vector<Command> read(const std::string& text, const std::string& file);

/// Runs commands in the viewer's interface, without a display. Each one sees all that those before it asked for
/// computed and drawn. Throws Error where there is no OpenGL 3.3, or when a file cannot be written.
void run(ViewerState state, std::span<const Command> commands, WindowSize size);

}  // namespace glassbox::script
