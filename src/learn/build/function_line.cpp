#include "learn/build/function_line.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "scene/text_file.hpp"

namespace glassbox::learn {
namespace {

/// The lines of a text without surrounding spaces: learners indent as they like.
std::vector<std::string_view> bare_lines(std::string_view text) {
    std::vector<std::string_view> lines = lines_of(text);
    for (std::string_view& line : lines) line = trimmed(line);
    return lines;
}

/// Returns the line of a text that contains `not_written<…>("function")`; the number of lines if none does.
std::size_t not_written_at(const std::vector<std::string_view>& lines, std::string_view function) {
    const std::string name = "(\"" + std::string(function) + "\")";
    const auto says = [&](std::string_view line) {
        return !line.starts_with("//") && line.find("not_written<") != line.npos && line.find(name) != line.npos;
    };
    return static_cast<std::size_t>(std::ranges::find_if(lines, says) - lines.begin());
}

/// Whether a declaration may begin after that line.
bool is_boundary(std::string_view line) {
    return line.empty() || line.starts_with("//") || line.starts_with("template") ||
           std::string_view(";{}:").find(line.back()) != std::string_view::npos;
}

/// Returns the line with the opening brace of the block that contains the line `inside`.
std::size_t opening_line(const std::vector<std::string_view>& lines, std::size_t inside) {
    int closed = 0;
    for (std::size_t i = inside; i-- > 0;) {
        for (std::size_t c = lines[i].size(); c-- > 0;) {
            closed += lines[i][c] == '}' ? 1 : lines[i][c] == '{' ? -1 : 0;
            if (closed < 0) return i;
        }
    }
    return 0;
}

/// Returns the line where the declaration begins of the function whose body contains that line.
std::size_t begin_of_declaration(const std::vector<std::string_view>& lines, std::size_t body) {
    std::size_t begin = opening_line(lines, body);
    while (begin > 0 && !is_boundary(lines[begin - 1])) --begin;
    return begin;
}

/// What a declaration that begins with that line declares: "dot", "operator+", "operator()".
std::string declared_name(std::string_view line) {
    const std::string_view before = line.substr(0, line.find('('));
    const std::string_view name = before.substr(before.find_last_of(' ') + 1);
    return std::string(name) + (name == "operator" ? "()" : "");
}

/// Whether a line declares a function of that name, and does not only call it.
bool declares(std::string_view line, const std::string& name) {
    const std::size_t at = line.find(" " + name + "(");
    if (at == std::string_view::npos || at == 0) return false;
    const std::string_view before = line.substr(0, at);
    return before.find_first_of("(=") == std::string_view::npos && !before.starts_with("//") &&
           !before.starts_with("return") && !before.starts_with("else");
}

}  // namespace

std::size_t line_of_function(std::string_view header, std::string_view starter, std::string_view function) {
    const std::vector<std::string_view> mine = bare_lines(header), given = bare_lines(starter);
    if (const std::size_t open = not_written_at(mine, function); open < mine.size()) return open + 1;
    const std::size_t body = not_written_at(given, function);
    if (body == given.size()) return 0;
    // Several functions may have the name, such as the operator() of Textbook and of Stable: take the one at the same
    // place among them as in the starter.
    const std::size_t begin = begin_of_declaration(given, body);
    const std::string name = declared_name(given[begin]);
    const auto is_one = [&](std::string_view line) { return declares(line, name); };
    auto before = std::count_if(given.begin(), given.begin() + static_cast<std::ptrdiff_t>(begin), is_one);
    for (std::size_t i = 0; i < mine.size(); ++i)
        if (is_one(mine[i]) && before-- == 0) return i + 1;
    return 0;
}

}  // namespace glassbox::learn
