#include "learn/build/headers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "learn/build/compiler.hpp"

namespace glassbox::learn {

namespace fs = std::filesystem;

constexpr std::uintmax_t largest_header = 16 << 20;  // bytes

std::vector<fs::path> headers_in(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code failed;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, failed), end;
    for (; !failed && entry != end; entry.increment(failed)) {
        std::error_code none;
        const fs::path extension = entry->path().extension();
        if ((extension == ".hpp" || extension == ".h") && entry->is_regular_file(none)) files.push_back(entry->path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string content_of(const fs::path& file) {
    std::error_code none;
    if (!fs::is_regular_file(file, none) || fs::file_size(file, none) > largest_header) return "";
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string state_of(const fs::path& file) {
    std::error_code none;
    return fmt::format("{} {} {}", file.string(), fs::file_size(file, none),
                       fs::last_write_time(file, none).time_since_epoch().count());
}

void add_headers(std::vector<std::string>& parts, const fs::path& folder) {
    for (const fs::path& file : headers_in(folder)) {
        parts.push_back(file.string());
        parts.push_back(content_of(file));
    }
}

std::string fingerprint_of_headers(const fs::path& folder) {
    std::vector<std::string> parts;
    add_headers(parts, folder);
    return fingerprint(parts);
}

}  // namespace glassbox::learn
