#pragma once
#include "viewer/script/command.hpp"
#include "viewer/script/words.hpp"

namespace glassbox::script {

/// The command that a line's words, at least one, ask for. Throws Error if they ask for none.
Command command_of(const Words& words);

/// The command `set NAME VALUE`. Throws Error.
Command set(const Words& words);

}  // namespace glassbox::script
