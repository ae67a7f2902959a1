#include "scene/toml_depth.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace glassbox {
namespace {

/// The end of the string that begins at `start` with one quote or three: the offset after its last quote.
std::size_t end_of_string(std::string_view toml, std::size_t start) {
    const char quote = toml[start];
    const bool is_long = toml.substr(start).starts_with(std::string(3, quote));
    const std::string end(is_long ? 3 : 1, quote);
    for (std::size_t at = start + end.size(); at < toml.size(); ++at) {
        if (quote == '"' && toml[at] == '\\') ++at;
        else if (!is_long && toml[at] == '\n') return at;  // not closed: reads on as if it were
        else if (toml.substr(at).starts_with(end)) return at + end.size();
    }
    return toml.size();
}

}  // namespace

std::optional<std::size_t> first_too_deep(std::string_view toml) {
    std::vector<std::size_t> outside;  // for each open bracket, the levels outside it
    std::size_t levels = 0;            // the current ones: the section's, and the brackets'
    std::size_t dots = 0;              // in the current key, or in the value, where they add no levels
    std::size_t of_key = 0;            // the levels that the key before this value adds
    bool in_header = false, at_line_start = true;
    for (std::size_t at = 0; at < toml.size();) {
        const char c = toml[at];
        if (c == '"' || c == '\'') {
            at = end_of_string(toml, at);
            at_line_start = false;
            continue;
        }
        if (c == '#') {
            at = std::min(toml.find('\n', at), toml.size());
            continue;
        }
        if (c == '\n') {
            if (in_header) levels = dots + 1;
            in_header = false;
            at_line_start = outside.empty();
            dots = 0;
            if (outside.empty()) of_key = 0;
        } else if (c == '.') {
            ++dots;
        } else if (c == '=') {
            of_key = dots + 1;
            dots = 0;
        } else if (c == ',') {
            dots = of_key = 0;
        } else if (c == '[' && at_line_start) {
            in_header = true;
            levels = 0;
        } else if ((c == '[' || c == '{') && !in_header) {
            outside.push_back(levels);
            levels += of_key + 1;
            dots = of_key = 0;
        } else if ((c == ']' || c == '}') && !outside.empty()) {
            levels = outside.back();
            outside.pop_back();
            dots = of_key = 0;
        }
        if (levels + of_key + dots + (in_header ? 1 : 0) > most_toml_levels) return at;
        if (c != ' ' && c != '\t' && c != '\r' && c != '\n') at_line_start = false;
        ++at;
    }
    return std::nullopt;
}

}  // namespace glassbox
