#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace glassbox::learn {

/// Returns the headers in a folder and its subfolders, in order; regular files only. A folder that cannot be read has
/// none.
std::vector<std::filesystem::path> headers_in(const std::filesystem::path& folder);

/// Returns the contents of a regular file; "" if it is not one, cannot be read, or is larger than anyone writes by
/// hand.
std::string content_of(const std::filesystem::path& file);

/// Returns a file's present state without reading it: its name, size and time.
std::string state_of(const std::filesystem::path& file);

/// Adds names and contents of the headers in a folder, each as a part of a fingerprint.
void add_headers(std::vector<std::string>& parts, const std::filesystem::path& folder);

/// Returns a fingerprint of all headers in a folder; it differs after each change.
std::string fingerprint_of_headers(const std::filesystem::path& folder);

}  // namespace glassbox::learn
