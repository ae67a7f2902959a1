#include "learn/build/meant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "learn/build/headers.hpp"
#include "learn/build/source_text.hpp"
#include "scene/suggestion.hpp"
#include "scene/text_file.hpp"

namespace glassbox::learn {
namespace {

namespace fs = std::filesystem;

bool in_a_name(char c) { return in_a_word(c) || c == '.'; }

std::string_view word_at_front(std::string_view text) {
    return text.substr(0, static_cast<std::size_t>(std::ranges::find_if_not(text, in_a_word) - text.begin()));
}
std::string_view word_at_end(std::string_view text) {
    std::size_t begin = text.size();
    while (begin > 0 && in_a_word(text[begin - 1])) --begin;
    return text.substr(begin);
}

/// "Ray" of "const glassbox::Ray<Real>&".
std::string bare_type(std::string_view type) {
    type = trimmed(type.substr(0, type.find_first_of("<&*")));
    return std::string(word_at_end(type));
}

/// "Interval<Real>" of "static constexpr Interval<Real>".
std::string returned_type(std::string_view before_name) {
    std::string_view type = trimmed(before_name);
    for (bool any = true; any;) {
        any = false;
        for (const std::string_view word : {"constexpr ", "inline ", "static ", "friend ", "[[nodiscard]] "})
            if (type.starts_with(word)) type = trimmed(type.substr(word.size())), any = true;
    }
    return std::string(type);
}

/// The name that an error says is not declared; "" if it is another error.
std::string undeclared(std::string_view message) {
    for (const auto& [opening, ending] : {std::pair{"'", "' was not declared in this scope"},
                                          {"use of undeclared identifier '", "'"},
                                          {"there are no arguments to '", "' that depend on a template parameter"}}) {
        const std::string_view begin = opening;
        if (!message.starts_with(begin)) continue;
        const std::string_view rest = message.substr(begin.size());
        const std::size_t end = rest.find('\'');
        if (end != std::string_view::npos && rest.substr(end).starts_with(ending))
            return std::string(rest.substr(0, end));
    }
    return "";
}

/// The source at an error's column, and what stands before it.
struct Here {
    std::string_view before, after;
};

Here at_column(const CompileError& error) {
    const std::size_t at = std::min(error.place.column == 0 ? 0 : error.place.column - 1, error.source.size());
    return {std::string_view(error.source).substr(0, at), std::string_view(error.source).substr(at)};
}

/// P, where an argument has such a member: "did you mean ray.P?"
std::string of_an_argument(const std::string& name, const CompileError& error, const std::vector<fs::path>& folders) {
    std::vector<std::string> meant;
    for (const auto& [type, argument] : declared_above(content_of(error.place.file), error.place.line).parameters) {
        const std::vector<std::string> members = members_of(type, folders);
        if (std::ranges::find(members, name) != members.end()) meant.push_back(argument + '.' + name);
    }
    return meant.empty() ? "" : fmt::format("Nothing is called {} here; did you mean {}?", name, either(meant));
}

std::string of_a_name(const std::string& name, const CompileError& error, const std::vector<fs::path>& folders) {
    if (name == "max" || name == "min")
        return fmt::format("Write std::{}, and give it numbers of one type: Real(0) for 0.", name);
    if (name == "choose") return "There is no choose here: write condition ? a : b.";
    if (std::string words = of_an_argument(name, error, folders); !words.empty()) return words;
    const Here here = at_column(error);
    const std::string_view next = trimmed(here.after.substr(std::min(name.size(), here.after.size())));
    if (trimmed(here.before).empty() && next.starts_with('=') && !next.starts_with("=="))
        return fmt::format("Nothing is called {0} here. To make a variable of that name, write const auto {0} = …",
                           name);
    return "";
}

/// const v = …, without a type.
std::string of_a_type(const CompileError& error) {
    const Here here = at_column(error);
    const std::string_view name = word_at_front(here.after), next = trimmed(here.after.substr(name.size()));
    const bool lacks = error.message.find("does not name a type") != std::string::npos ||
                       error.message.find("type specifier") != std::string::npos;
    if (!lacks || name.empty() || word_at_end(trimmed(here.before)) != "const" || !next.starts_with('=')) return "";
    return fmt::format("A type is missing before {0}: write const auto {0} = …", name);
}

/// A template without <Real>. g++ points behind its name, clang++ at it, and names it.
std::string of_a_template(const CompileError& error) {
    const Here here = at_column(error);
    std::string_view name;
    if (error.message.starts_with("missing template arguments before")) name = word_at_end(trimmed(here.before));
    else if (error.message.starts_with("use of ") && error.message.ends_with("requires template arguments"))
        name = word_at_front(here.after);
    return name.empty() ? "" : fmt::format("{0} is a template: write {0}<Real>.", name);
}

/// A member of what an optional holds: best.t.
std::string of_an_optional(const CompileError& error) {
    const bool is_optional = error.message.find("std::optional<") != std::string::npos &&
                             (error.message.find("has no member named") != std::string::npos ||
                              error.message.starts_with("no member named"));
    const Here here = at_column(error);
    if (!is_optional || !here.before.ends_with('.')) return "";
    const std::string_view before = here.before.substr(0, here.before.size() - 1);
    const std::string_view optional = before.substr(before.size() - length_of_operand(before, true));
    return fmt::format("What an optional holds is reached by ->, where it holds something: {}->{}.", optional,
                       word_at_front(here.after));
}

/// pow(r, 2), of a number that is not built in.
std::string of_a_square(const CompileError& error) {
    const std::size_t open = error.source.find("pow(");
    const bool is_pow =
        error.message.starts_with("no matching function for call to 'pow") ||
        (error.message.starts_with("cannot convert '") && error.message.find("Real' to ") != std::string::npos);
    if (!is_pow || open == std::string::npos) return "";
    const std::string_view rest = std::string_view(error.source).substr(open + 4);
    const std::size_t length = length_of_operand(rest, false);
    const std::string_view base = rest.substr(0, length), then = trimmed(rest.substr(length));
    if (base.empty() || !then.starts_with(',') || !trimmed(then.substr(1)).starts_with("2)")) return "";
    return fmt::format("pow is for built-in numbers alone, and Real may be another: write {0} * {0}.", base);
}

/// condition ? {a, b} : {b, a}.
std::string of_braces(const CompileError& error) {
    const Here here = at_column(error);
    const std::string_view before = trimmed(here.before);
    const bool is_clang =
        error.message.starts_with("initializer list cannot be used on the right hand side of operator");
    const bool is_gcc = error.message.starts_with("expected primary-expression before '{'") &&
                        (before.ends_with('?') || before.ends_with(':'));
    if (!is_clang && !is_gcc) return "";
    const std::string type = declared_above(content_of(error.place.file), error.place.line).returns;
    const bool returns = error.source.find("return") != std::string::npos && !type.empty();
    return fmt::format("Beside ? and : braces need their type before them{}.",
                       returns ? fmt::format(": write {}{{…}}", type) : "");
}

}  // namespace

std::size_t length_of_operand(std::string_view text, bool backwards) {
    const auto at = [&](std::size_t i) { return text[backwards ? text.size() - 1 - i : i]; };
    const char open = backwards ? ')' : '(', close = backwards ? '(' : ')';
    std::size_t end = 0;
    for (int depth = 0; end < text.size(); ++end) {
        if (at(end) == open) ++depth;
        else if (at(end) == close && --depth < 0) break;
        else if (depth == 0 && at(end) != close && !in_a_name(at(end))) break;
    }
    return end;
}

Declared declared_above(std::string_view source, std::size_t line) {
    const std::vector<std::string_view> lines = lines_of(source);
    std::size_t begin = std::min(line, lines.size());
    while (begin > 0 && !trimmed(lines[begin - 1]).starts_with("template")) --begin;
    if (begin == 0) return {};
    // From behind template <…>, which may have the declaration in its own line, to the body.
    std::string text;
    for (std::size_t i = begin - 1; i < lines.size() && text.find('{') == std::string::npos; ++i)
        text += std::string(lines[i]) + ' ';
    std::size_t depth = 0, behind = text.find('<');
    for (; behind < text.size(); ++behind) {
        depth += text[behind] == '<' ? 1 : 0;
        if (text[behind] == '>' && --depth == 0) break;
    }
    if (behind >= text.size()) return {};
    const std::string_view declaration = std::string_view(text).substr(behind + 1);
    const std::size_t open = declaration.find('(');
    if (open == std::string_view::npos) return {};
    const std::string_view before = trimmed(declaration.substr(0, open));
    Declared declared;
    declared.returns = returned_type(before.substr(0, before.size() - word_at_end(before).size()));
    std::string parameter;
    int inside = 1;
    for (const char c : declaration.substr(open + 1)) {
        if (c == '(' || c == '<') ++inside;
        if (c == ')' || c == '>') --inside;
        if (inside > 0 && (c != ',' || inside > 1)) {
            parameter += c;
            continue;
        }
        const std::string_view whole = trimmed(parameter), name = word_at_end(whole);
        if (!name.empty() && name.size() < whole.size())
            declared.parameters.push_back({bare_type(whole.substr(0, whole.size() - name.size())), std::string(name)});
        parameter.clear();
        if (inside == 0) break;
    }
    return declared;
}

std::vector<std::string> members_of(const std::string& name, const std::vector<std::filesystem::path>& folders) {
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::path& folder : folders)
        for (std::filesystem::path& file : headers_in(folder)) files.push_back(std::move(file));
    for (const std::filesystem::path& file : files) {
        bool inside = false;
        std::vector<std::string> members;
        const std::string text = content_of(file);
        for (const std::string_view line : lines_of(text)) {
            if (line.starts_with("struct " + name + " {") && line.find('}') == std::string_view::npos) inside = true;
            if (inside && line.starts_with("}")) break;
            // "    Vec3<Real> P, D;  ///< …", or with values in braces
            const std::string_view declared = line.substr(0, line.find(';'));
            if (!inside || declared.size() == line.size() || declared.find('(') != std::string_view::npos ||
                declared.find("static") != std::string_view::npos || declared.find("using") != std::string_view::npos)
                continue;
            // A name is the last word before a comma, a value or the end.
            std::string word, last;
            int depth = 0;
            bool has_value = false;
            for (const char c : std::string(declared) + ',') {
                if (c == '{' || c == '<') ++depth;
                has_value |= c == '=' || (c == '{' && !word.empty()) || (c == '{' && !last.empty());
                if (!has_value && depth == 0 && (std::isalnum(static_cast<unsigned char>(c)) || c == '_')) word += c;
                else if (!word.empty()) last = std::exchange(word, "");
                if (c == ',' && depth == 0 && !last.empty()) {
                    members.push_back(std::exchange(last, ""));
                    has_value = false;
                }
                if (c == '}' || c == '>') --depth;
            }
        }
        if (!members.empty()) return members;
    }
    return {};
}

std::string meant(const CompileError& error, const std::vector<std::filesystem::path>& folders) {
    if (const std::string name = undeclared(error.message); !name.empty()) return of_a_name(name, error, folders);
    for (const auto& known : {of_a_type, of_a_template, of_an_optional, of_a_square, of_braces})
        if (std::string words = known(error); !words.empty()) return words;
    return "";
}

std::string takes_degrees(std::string_view source, std::size_t line) {
    const std::vector<std::string_view> lines = lines_of(source);
    if (line == 0 || line > lines.size()) return "";
    constexpr std::string_view call = "cos_sin(";
    const std::size_t at = lines[line - 1].find(call);
    if (at == std::string_view::npos) return "";
    const std::string_view argument = word_at_front(lines[line - 1].substr(at + call.size()));
    if (!lines[line - 1].substr(at + call.size() + argument.size()).starts_with(')')) return "";
    for (const auto& [type, name] : declared_above(source, line).parameters)
        if (name == argument && type == "Turn")
            return fmt::format("cos_sin takes an angle in degrees, a number: cos_sin({}.degrees).", argument);
    return "";
}

}  // namespace glassbox::learn
