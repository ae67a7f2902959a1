#pragma once
#include <string>
#include <string_view>

namespace glassbox {

/// Writes one line to stderr, printable whatever file names it contains. Ignores a stderr that is full or closed.
void tell(std::string_view line);

/// Writes to stdout, after what was printed before. Throws Error if the write fails.
void print_bytes(std::string_view bytes);

/// Writes text for a reader to stdout, printable whatever it quotes.
void print_text(std::string_view text);

/// Writes a file's name to stdout, as a line: unchanged for a script, printable for a terminal.
void print_name(const std::string& name);

/// Throws Error if something printed to stdout was not written, because the disk is full, for example.
void check_printed();

/// Opens /dev/null in place of a closed stderr: otherwise the next opened file would take its number, and the messages.
void keep_stderr_open();

}  // namespace glassbox
