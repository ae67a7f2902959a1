#include "viewer/model/story/functions.hpp"

#include <algorithm>

#include "scene/text_file.hpp"

namespace glassbox {

namespace {

bool is_part_of_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

std::string_view without_comment(std::string_view line) { return line.substr(0, line.find("//")); }

/// The name before that place in a text.
std::string_view name_before(std::string_view text, std::size_t end) {
    std::size_t begin = end;
    while (begin > 0 && is_part_of_name(text[begin - 1])) --begin;
    return text.substr(begin, end - begin);
}

/// The name of the function that a text before a brace begins; empty if it begins none.
std::string function_name(std::string_view head) {
    const std::size_t by_name = head.find("operator");
    if (by_name != std::string_view::npos) {
        const std::string_view rest = head.substr(by_name);
        if (rest.starts_with("operator()")) return "operator()";
        return std::string(rest.substr(0, rest.find('(')));
    }
    const std::size_t open = head.find('(');
    if (open == std::string_view::npos || head.find('=') < open || head.find('[') < open) return {};
    const std::string_view name = name_before(head, open);
    for (const std::string_view keyword : {"if", "for", "while", "switch", "requires", "constexpr"})
        if (name == keyword) return {};
    return head.find("return ") < open ? std::string() : std::string(name);
}

/// Whether a list of parameters, from its opening parenthesis on, has one.
bool has_one_parameter(std::string_view list) {
    int depth = 0;
    for (const char c : list) {
        if (c == '(' || c == '<') ++depth;
        if (c == ')' || c == '>') --depth;
        if (c == ',' && depth == 1) return false;
        if (depth == 0) return true;
    }
    return false;
}

/// Whether an operator there, after this text, has an operand on its left.
bool has_left_operand(std::string_view before) {
    while (before.ends_with(' ')) before.remove_suffix(1);
    if (before.empty() || before.ends_with("return")) return false;
    const char last = before.back();
    return is_part_of_name(last) || last == ')' || last == ']' || last == '}';
}

bool has_sign(std::string_view line, std::string_view sign, bool is_unary) {
    for (std::size_t at = line.find(sign); at != std::string_view::npos; at = line.find(sign, at + sign.size())) {
        const bool joined =
            sign.size() == 1 && (line.substr(at + 1).starts_with(sign) || line.substr(at + 1).starts_with('=') ||
                                 line.substr(at + 1).starts_with('>') || line.substr(0, at).ends_with(sign));
        if (!joined && has_left_operand(line.substr(0, at)) != is_unary) return true;
    }
    return false;
}

}  // namespace

std::vector<SourceFunction> functions_of(const SourceFile& file) {
    struct Open {
        std::string function, structure;  // what a brace begins
        std::size_t index;
    };
    std::vector<SourceFunction> all;
    std::vector<Open> open;
    std::string head;  // since the last brace or semicolon
    std::size_t named_at = 0;
    const std::vector<std::string_view> text = lines(file);
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (trimmed(text[i]).starts_with('#')) continue;
        head += ' ';
        for (const char c : without_comment(text[i])) {
            if (c == '(' && head.find('(') == std::string::npos) named_at = i + 1;
            if (c == '{') {
                const bool in_function = std::ranges::any_of(open, [](const Open& o) { return !o.function.empty(); });
                Open next{in_function ? std::string() : function_name(head), {}, all.size()};
                if (const std::size_t at = head.find("struct "); !in_function && at != std::string::npos) {
                    const std::string rest = head.substr(at + 7);
                    next.structure = rest.substr(0, rest.find_first_of(" :"));
                    next.function.clear();
                }
                if (!next.function.empty()) {
                    std::string name = next.function;
                    if (name == "operator()" && !open.empty()) name = open.back().structure;
                    const std::size_t list =
                        head.find('(', next.function == "operator()" ? head.find("operator()") + 10 : 0);
                    all.push_back({name,
                                   list != std::string::npos && has_one_parameter(std::string_view(head).substr(list)),
                                   named_at, 0, i + 1});
                }
                open.push_back(std::move(next));
                head.clear();
            } else if (c == '}') {
                if (!open.empty() && !open.back().function.empty()) all[open.back().index].last = i + 1;
                if (!open.empty()) open.pop_back();
                head.clear();
            } else if (c == ';') head.clear();
            else head += c;
        }
    }
    return all;
}

std::size_t only_line_with(const SourceFile& file, const SourceFunction& function, std::string_view sign,
                           bool is_unary) {
    const std::vector<std::string_view> text = lines(file);
    std::size_t found = 0;
    for (std::size_t line = function.body; line <= std::min(function.last, text.size()); ++line) {
        std::string_view code = without_comment(text[line - 1]);
        if (line == function.body) code = code.substr(std::min(code.find('{'), code.size()));
        if (!has_sign(code, sign, is_unary)) continue;
        if (found != 0) return 0;
        found = line;
    }
    return found;
}

}  // namespace glassbox
