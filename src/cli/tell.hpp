#pragma once
#include <string>

namespace glassbox {

/// Writes one line to stderr. It is one line whatever file names are in it, and a stderr that is full or closed is not
/// worth ending the program for.
void tell(std::string line);

/// Throws Error if something that was printed to stdout did not get there: the disk is full, say.
void check_printed();

/// Opens /dev/null in the place of a stderr that was closed: the next file to be opened would take its number, and the
/// messages.
void keep_stderr_open();

}  // namespace glassbox
