#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace glassbox {

/// Why a file cannot be read ("there is no such file", "it is a directory, not a file"), if it cannot.
std::optional<std::string> why_unreadable(const std::filesystem::path& file);

/// All of a text file. Throws Error if it cannot be read, or holds a byte 0 and so is not text.
std::string read_text(const std::filesystem::path& file);

/// The same, for what is read line by line: without a byte order mark, and each carriage return that ends a line by
/// itself, as on old Macs, is a newline. Those before a newline stay, so that columns are those of the file.
std::string read_lines(const std::filesystem::path& file);

/// Where the first byte lies that is not well-formed UTF-8, if there is one.
std::optional<std::size_t> first_not_utf8(std::string_view text);

/// The text between quotes, fit to stand in a line of a message: cut where it is long, and printable.
std::string in_quotes(std::string_view text);

}  // namespace glassbox
