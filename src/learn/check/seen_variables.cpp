#include "learn/check/seen_variables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string_view>
#include <vector>

#include "learn/build/source_text.hpp"

namespace glassbox::learn {
namespace {

constexpr std::size_t most_variables = 8;
constexpr int furthest = 3;  ///< variables that variables were computed from, so many steps back

struct Token {
    std::string_view text;
    std::size_t at;  ///< its place in the source
    int line;
};

bool is_word(std::string_view text) { return in_a_word(text[0]) && !std::isdigit(static_cast<unsigned char>(text[0])); }

/// The source's tokens, as far as they matter here: words, numbers, operators. A text is one token, '"'.
std::vector<Token> tokens_of(std::string_view source) {
    constexpr std::array<std::string_view, 14> operators{"::", "->", "==", "!=", "<=", ">=", "&&",
                                                         "||", "+=", "-=", "*=", "/=", "++", "--"};
    std::vector<Token> tokens;
    int line = 1;
    bool begins_line = true;
    for (std::size_t i = 0; i < source.size();) {
        const char c = source[i];
        const std::string_view rest = source.substr(i);
        std::size_t length = 1;
        if (c == '\n') ++line, begins_line = true;
        else if (rest.starts_with("//") || (c == '#' && begins_line)) {  // to its end, and on where a \ ends the line
            while (length < rest.size() && (rest[length] != '\n' || rest[length - 1] == '\\')) ++length;
            line += static_cast<int>(std::count(rest.begin(), rest.begin() + static_cast<long>(length), '\n'));
        } else if (rest.starts_with("/*")) {
            length = std::min(rest.find("*/"), rest.size() - 2) + 2;
            line += static_cast<int>(std::count(rest.begin(), rest.begin() + static_cast<long>(length), '\n'));
        } else if (c == '"' || (c == '\'' && (i == 0 || !in_a_word(source[i - 1])))) {
            while (length < rest.size() && rest[length] != c) length += rest[length] == '\\' ? 2 : 1;
            ++length;
            tokens.push_back({rest.substr(0, 1), i, line});
        } else if (in_a_word(c)) {
            const bool number = std::isdigit(static_cast<unsigned char>(c));
            while (length < rest.size() && (in_a_word(rest[length]) || (number && rest[length] == '.'))) ++length;
            tokens.push_back({rest.substr(0, length), i, line});
        } else if (!std::isspace(static_cast<unsigned char>(c))) {
            for (const std::string_view sign : operators)
                if (rest.starts_with(sign)) length = sign.size();
            tokens.push_back({rest.substr(0, length), i, line});
        }
        if (c != '\n' && !std::isspace(static_cast<unsigned char>(c))) begins_line = false;
        i += length;
    }
    return tokens;
}

bool is_one_of(std::string_view text, std::initializer_list<std::string_view> all) {
    return std::find(all.begin(), all.end(), text) != all.end();
}

bool is_keyword(std::string_view word) {
    return is_one_of(word, {"return", "else", "case",      "new",     "delete",   "throw",    "typename", "struct",
                            "class",  "enum", "namespace", "using",   "template", "operator", "goto",     "co_return",
                            "this",   "true", "false",     "nullptr", "sizeof",   "const",    "auto"});
}

/// The tokens of a test's source, with what we know of the variables in scope.
class Reader {
public:
    explicit Reader(std::string_view source) : source_(source), tokens_(tokens_of(source)) {}

    std::string read(const std::string& file) {
        std::string text = "#line 1 \"";
        for (const char c : file) text += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
        text += "\"\n";
        std::size_t copied = 0;
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            note_variables(i);
            const std::size_t end = is_check(i) ? end_of_check(i) : 0;
            if (end == 0) continue;
            const std::vector<std::string_view> names = variables_in(i + 2, end - 2);
            if (names.empty()) continue;
            std::string seen;
            for (const std::string_view name : names)
                seen += fmt::format("{}::glassbox::test::variable(\"{}\", {})", seen.empty() ? "" : ", ", name, name);
            text += source_.substr(copied, tokens_[i].at - copied);
            text += fmt::format("{{ const ::glassbox::test::Seen glassbox_seen({}, {{{}}}); ", tokens_[i].line, seen);
            const std::size_t after = tokens_[end - 1].at + 1;
            text += source_.substr(tokens_[i].at, after - tokens_[i].at);
            text += " }";
            copied = after;
        }
        text += source_.substr(copied);
        return text;
    }

private:
    std::string_view at(std::size_t i) const { return i < tokens_.size() ? tokens_[i].text : std::string_view(";"); }
    std::string_view before(std::size_t i) const { return i > 0 ? at(i - 1) : std::string_view(";"); }

    bool is_check(std::size_t i) const {
        return (at(i).starts_with("CHECK") || at(i).starts_with("REQUIRE")) && at(i + 1) == "(" &&
               is_one_of(before(i), {";", "{", "}", ")", "else"});
    }

    /// The token after the check's semicolon; 0 if there is none.
    std::size_t end_of_check(std::size_t i) const {
        const std::size_t close = closing(i + 1);
        return at(close) == ")" && at(close + 1) == ";" ? close + 2 : 0;
    }

    /// The token that closes what opens here.
    std::size_t closing(std::size_t open) const {
        int depth = 0;
        for (std::size_t i = open; i < tokens_.size(); ++i) {
            if (is_one_of(at(i), {"(", "[", "{"})) ++depth;
            if (is_one_of(at(i), {")", "]", "}"}) && --depth == 0) return i;
        }
        return tokens_.size();
    }

    /// Whether a variable is declared here: after a type, and before what may follow a name.
    bool is_declared(std::size_t i) const {
        const std::string_view last = before(i), next = at(i + 1);
        if (!is_word(at(i)) || is_keyword(at(i))) return false;
        if (last == "," && std::islower(static_cast<unsigned char>(at(i)[0]))) return next == "=" || next == "{";
        const bool after_type =
            (is_word(last) && !is_keyword(last)) || last == "auto" || is_one_of(last, {">", "&", "*"});
        return after_type && is_one_of(next, {"=", "{", ";", ":", ",", ")"});
    }

    void note_variables(std::size_t i) {
        if (at(i) == "{") scopes_.emplace_back();
        if (at(i) == "}" && scopes_.size() > 1) scopes_.pop_back();
        if (is_declared(i)) scopes_.back()[at(i)] = at(i + 1) == "=" || at(i + 1) == "{" ? i + 1 : 0;
        if (at(i) != "[" || !is_one_of(before(i), {"&", "auto"})) return;
        const std::size_t close = closing(i);  // const auto& [a, b] = …
        if (!is_one_of(at(close + 1), {"=", ":"})) return;
        for (std::size_t k = i + 1; k < close; ++k)
            if (is_word(at(k))) scopes_.back()[at(k)] = close + 1;
    }

    /// Where a variable's value is computed, 0 if that is not known; none if it is no variable in scope.
    const std::size_t* computed_at(std::string_view name) const {
        for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope)
            if (const auto found = scope->find(name); found != scope->end()) return &found->second;
        return nullptr;
    }

    /// Whether the word stands for a value by itself: it is no member, function, template or type.
    bool is_value(std::size_t i) const {
        return is_word(at(i)) && !is_keyword(at(i)) && !is_one_of(before(i), {".", "->", "::"}) &&
               !is_one_of(at(i + 1), {"(", "<", "{", "::"}) && computed_at(at(i)) &&
               !(at(i + 1) == "." && at(i + 3) == "(");  // dice.vector(1)
    }

    bool has_lambda(std::size_t begin, std::size_t end) const {
        for (std::size_t i = begin; i < end; ++i)
            if (at(i) == "[" && !is_word(before(i)) && !is_one_of(before(i), {")", "]"})) return true;
        return false;
    }

    /// The variables named by some tokens, then those from which they were computed.
    std::vector<std::string_view> variables_in(std::size_t begin, std::size_t end) const {
        std::vector<std::string_view> names;
        if (has_lambda(begin, end)) return names;
        std::vector<std::pair<std::size_t, std::size_t>> ranges{{begin, end}};
        for (int step = 0; step < furthest; ++step) {
            std::vector<std::pair<std::size_t, std::size_t>> further;
            for (const auto& [from, to] : ranges)
                for (std::size_t i = from; i < to; ++i) {
                    if (!is_value(i) || std::ranges::find(names, at(i)) != names.end()) continue;
                    if (names.size() == most_variables) return names;
                    names.push_back(at(i));
                    const std::size_t computed = *computed_at(at(i));
                    const std::size_t last = computed == 0 ? 0 : end_of_value(computed);
                    if (computed != 0 && !has_lambda(computed, last)) further.emplace_back(computed, last);
                }
            ranges = std::move(further);
        }
        return names;
    }

    /// The token after a variable's first value.
    std::size_t end_of_value(std::size_t i) const {
        if (at(i) == "{") return closing(i);
        for (; i < tokens_.size() && !is_one_of(at(i), {";", ",", ")", "}"}); ++i)
            if (is_one_of(at(i), {"(", "[", "{"})) i = closing(i);
        return i;
    }

    std::string_view source_;
    std::vector<Token> tokens_;
    std::vector<std::map<std::string_view, std::size_t>> scopes_{1};  ///< name → where it is computed
};

}  // namespace

std::string with_seen_variables(const std::string& source, const std::string& file) {
    return Reader(source).read(file);
}

}  // namespace glassbox::learn
