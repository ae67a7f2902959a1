#include "learn/course/starter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "scene/text_file.hpp"

namespace glassbox::learn {
namespace {

using Lines = std::vector<std::string>;

std::string_view indent_of(std::string_view line) {
    return line.substr(0, std::min(line.find_first_not_of(' '), line.size()));
}

/// A line without indentation and without a comment at its end; no string of ours has // in it.
std::string_view code_of(std::string_view line) {
    line.remove_prefix(indent_of(line).size());
    line = line.substr(0, line.find("//"));
    while (line.ends_with(' ')) line.remove_suffix(1);
    return line;
}

Lines code_lines(const std::string& body) {
    Lines code;
    for (const std::string_view line : lines_of(body))
        if (!code_of(line).empty()) code.emplace_back(code_of(line));
    return code;
}

struct Span {
    std::size_t begin, end;
};

/// The lines from `begin` on that are this code, comments between them passed over.
std::optional<Span> match_at(const Lines& lines, std::size_t begin, const Lines& code) {
    std::size_t at = begin;
    for (const std::string& wanted : code) {
        while (at < lines.size() && at > begin && code_of(lines[at]).empty()) ++at;
        if (at == lines.size() || code_of(lines[at]) != wanted) return {};
        ++at;
    }
    return Span{begin, at};
}

/// Where the body stands first, with the comments that it begins with.
std::optional<Span> find_body(const Lines& lines, const Lines& code) {
    for (std::size_t begin = 0; begin < lines.size(); ++begin)
        if (std::optional<Span> span = match_at(lines, begin, code)) {
            while (span->begin > 0 && lines[span->begin - 1].find("//") == indent_of(lines[span->begin - 1]).size())
                --span->begin;
            return span;
        }
    return {};
}

/// Adds the include of not_written.hpp, in order, to the first group of our headers, or after all includes.
void add_include(Lines& lines) {
    const std::string ours = "#include <not_written.hpp>";
    const auto is_include = [](const std::string& line) { return line.starts_with("#include"); };
    const auto is_of_header = [&](const std::string& line) { return is_include(line) && line.ends_with(".hpp>"); };
    auto at = std::find_if(lines.begin(), lines.end(), is_of_header);
    if (at == lines.end()) at = std::find_if(lines.rbegin(), lines.rend(), is_include).base();
    else
        while (at != lines.end() && is_of_header(*at) && *at < ours) ++at;
    lines.insert(at, ours);
}

}  // namespace

std::string starter_from(const std::string& solution, const Exercise& exercise, const std::string& header) {
    const std::vector<std::string_view> all = lines_of(solution);
    Lines lines(all.begin(), all.end());
    for (const Function& function : exercise.functions) {
        if (function.header != header) continue;
        const std::optional<Span> body = find_body(lines, code_lines(function.hints[hint_tiers - 1]));
        if (!body)
            throw error_at(
                function.place,
                fmt::format("the line of {} is not its body in {}; it must have all lines of it, but for comments",
                            function.name, header));
        const std::string indent(indent_of(lines[body->begin]));  // of a body's first line, or the comment before it
        Lines stub;
        if (!function.turn.empty()) stub.push_back(fmt::format("{}// Your turn: {}", indent, function.turn));
        stub.push_back(fmt::format("{}return not_written<{}>(\"{}\");", indent, function.returns, function.name));
        const auto from = lines.begin() + static_cast<std::ptrdiff_t>(body->begin);
        lines.erase(from, lines.begin() + static_cast<std::ptrdiff_t>(body->end));
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(body->begin), stub.begin(), stub.end());
    }
    add_include(lines);
    return fmt::format("{}\n", fmt::join(lines, "\n"));
}

}  // namespace glassbox::learn
