#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace glassbox::learn {

/// The headers in a folder and the folders in it, in order; plain files only. What cannot be looked into has none.
std::vector<std::filesystem::path> headers_in(const std::filesystem::path& folder);

/// All that is in a plain file; "" if it is none, cannot be read, or is larger than anyone writes by hand.
std::string content_of(const std::filesystem::path& file);

/// What a file is now, without reading it: its name, its size, its time.
std::string state_of(const std::filesystem::path& file);

/// Names and contents of the headers in a folder, each a part of a fingerprint.
void add_headers(std::vector<std::string>& parts, const std::filesystem::path& folder);

/// A fingerprint of all headers in a folder: another one after each change.
std::string fingerprint_of_headers(const std::filesystem::path& folder);

}  // namespace glassbox::learn
