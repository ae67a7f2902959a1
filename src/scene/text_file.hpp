#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glassbox {

/// Why a file cannot be read ("there is no such file", "it is a directory, not a file"); nothing if it can.
std::optional<std::string> why_unreadable(const std::filesystem::path& file);

/// Reads a whole text file. Throws Error if it cannot be read, or holds a byte 0 and so is not text.
std::string read_text(const std::filesystem::path& file);

/// The same for text to be read line by line: drops a byte order mark, and turns each carriage return that ends a line
/// by itself, as on old Macs, into a newline. Those before a newline stay, so that columns match the file.
std::string read_lines(const std::filesystem::path& file);

/// The lines of a text, without their newlines; a last newline begins no further line.
std::vector<std::string_view> lines_of(std::string_view text);

/// The text without blanks at its ends.
std::string_view trimmed(std::string_view text);

/// The offset of the first byte that is not well-formed UTF-8, if there is one.
std::optional<std::size_t> first_not_utf8(std::string_view text);

/// The text in quotes, for a line of a message: shortened if it is long, and printable.
std::string in_quotes(std::string_view text);

}  // namespace glassbox
