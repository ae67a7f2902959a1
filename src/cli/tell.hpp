#pragma once
#include <string>
#include <string_view>

namespace glassbox {

/// Writes one line to stderr. It is one printable line whatever file names are in it, and a stderr that is full or
/// closed is not worth ending the program for.
void tell(std::string_view line);

/// Writes to stdout, at the end of what is there already. Throws Error if it is not taken.
void print_bytes(std::string_view bytes);

/// Writes text to be read to stdout, printable whatever it quotes.
void print_text(std::string_view text);

/// Writes a file's name to stdout, as a line: as it is for a script that takes it, printable for a terminal.
void print_name(const std::string& name);

/// Throws Error if something that was printed to stdout did not get there: the disk is full, say.
void check_printed();

/// Opens /dev/null in the place of a stderr that was closed: the next file to be opened would take its number, and the
/// messages.
void keep_stderr_open();

}  // namespace glassbox
