#include "learn/build/unclosed.hpp"

#include <fmt/format.h>

#include "learn/build/source_text.hpp"

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

namespace glassbox::learn {
namespace {

struct Spot {
    std::size_t line = 0, column = 0;
};

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v'; }

/// The beginning of what a brace opens, or of any other statement.
struct Statement {
    std::size_t begin = std::string_view::npos;  ///< where its first word stands; npos before that
    std::size_t indentation = 0;                 ///< of the line where it begins
    int parentheses = 0;                         ///< how many are open: a ; between them ends no statement
};

/// A brace that is open.
struct Brace {
    Spot spot;
    std::size_t of_line = 0, of_statement = 0;  ///< their indentations
    bool is_namespace = false;                  ///< what stands in it is not indented
    bool is_list = false;                       ///< of values, as in return {a, b}: no statement ends in it
};

/// An #if with its branches. Braces are counted in the first branch that may be compiled, as each may have its own.
struct Branches {
    std::vector<Brace> before;
    std::optional<std::vector<Brace>> after;
    bool is_dead = false;  ///< whether it is '#if 0', and this branch its first
};

/// Reads a file once, from its first character to its last. When reading by indentation, a block ends where a statement
/// is indented no more than the block, and a brace indented more than the block that it closes is one too many.
class Reading {
public:
    Reading(std::string_view source, bool by_indentation) : source_(source), by_indentation_(by_indentation) { read(); }

    bool is_even() const { return braces_.empty() && surplus_.empty(); }
    bool is_cut_off() const { return cut_off_; }  ///< within a comment or an #if: the compiler reports that
    const std::vector<Brace>& open() const { return braces_; }
    const std::vector<Spot>& surplus() const { return surplus_; }
    const std::optional<Unclosed>& text() const { return text_; }
    const std::optional<Unclosed>& comment() const { return comment_; }
    const std::optional<Unclosed>& list() const { return list_; }          ///< of values
    const std::optional<Unclosed>& missing() const { return missing_; }    ///< by indentation
    const std::optional<Unclosed>& too_many() const { return too_many_; }  ///< by indentation
    const std::optional<Spot>& end_of_all() const { return end_of_all_; }  ///< where a namespace ends, but not the file

private:
    void read() {
        while (at_ < source_.size()) {
            const char c = source_[at_];
            if (is_space(c)) step();
            else if (starts("//")) skip_line();
            else if (starts("/*")) read_comment();
            else if (c == '#' && is_first_in_line()) read_directive();
            else if (c == '"') read_text();
            else if (c == '\'') read_quoted('\'');
            else if (std::isdigit(static_cast<unsigned char>(c))) read_number();
            else if (in_a_word(c)) read_word();
            else read_sign(c);
        }
        cut_off_ |= !branches_.empty();
    }

    bool starts(std::string_view text) const { return source_.substr(at_, text.size()) == text; }
    bool is_dead() const {
        return std::ranges::any_of(branches_, [](const Branches& one) { return one.is_dead; });
    }
    Spot spot() const { return {line_, at_ - line_begin_ + 1}; }
    bool is_first_in_line() const {
        return std::ranges::all_of(source_.substr(line_begin_, at_ - line_begin_), is_space);
    }
    std::size_t indentation() const {
        std::size_t columns = 0;
        for (std::size_t i = line_begin_; i < at_ && is_space(source_[i]); ++i) columns += source_[i] == '\t' ? 4 : 1;
        return columns;
    }

    void step() {
        if (source_[at_++] != '\n') return;
        ++line_;
        line_begin_ = at_;
    }
    void step(std::size_t count) {
        while (count-- > 0 && at_ < source_.size()) step();
    }
    /// Skips to the end of the line; a backslash there joins the next line to it.
    void skip_line() {
        for (; at_ < source_.size() && source_[at_] != '\n'; step())
            if (starts("\\\n")) step();
    }

    void read_comment() {
        const Spot begin = spot();
        step(2);
        std::optional<Spot> inner;
        for (; at_ < source_.size() && !starts("*/"); step())
            if (starts("/*") && !starts("/*/") && !inner) inner = spot();
        cut_off_ |= at_ == source_.size();
        step(2);
        if (inner && !comment_)
            comment_ = {begin.line, begin.column,
                        fmt::format("The comment that begins here goes on beyond the /* of line {}: is its */ missing?",
                                    inner->line)};
    }

    void read_directive() {
        step();
        while (at_ < source_.size() && (source_[at_] == ' ' || source_[at_] == '\t')) step();
        std::size_t end = at_;
        while (end < source_.size() && in_a_word(source_[end])) ++end;
        const std::string_view name = source_.substr(at_, end - at_);
        std::string_view rest = source_.substr(end, source_.find('\n', end) - end);
        if (name.starts_with("if")) {
            rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
            const bool never = name == "if" && rest.starts_with('0') && (rest.size() == 1 || !in_a_word(rest[1]));
            branches_.push_back({braces_, {}, never});
        } else if ((name.starts_with("el") || name == "endif") && !branches_.empty()) {
            Branches& now = branches_.back();
            if (!now.is_dead && !now.after) now.after = braces_;
            now.is_dead = false;
            braces_ = now.before;
            if (name == "endif") {
                if (now.after) braces_ = *std::move(now.after);
                branches_.pop_back();
            }
        }
        if (name == "error" || name == "warning") return skip_line();  // may contain any text
        while (at_ < source_.size() && source_[at_] != '\n' && !starts("//") && !starts("/*")) {
            if (starts("\\\n")) step();
            step();
        }
    }

    void read_text() {
        if (raw_) return read_raw_text();
        read_quoted('"');
    }
    void read_quoted(char mark) {
        begin_statement();
        const Spot begin = spot();
        for (step(); at_ < source_.size() && source_[at_] != mark; step()) {
            if (source_[at_] == '\n') {
                if (!text_ && !is_dead()) text_ = {begin.line, begin.column, "This quotation mark is not closed."};
                return;
            }
            if (source_[at_] == '\\') step();
        }
        step(1);
    }
    void read_raw_text() {
        const Spot begin = spot();
        const std::size_t open = source_.find('(', at_);
        const std::string end =
            open == std::string_view::npos ? "" : ')' + std::string(source_.substr(at_ + 1, open - at_ - 1)) + '"';
        const std::size_t close = end.empty() ? open : source_.find(end, open);
        if (close == std::string_view::npos && !text_)
            text_ = {begin.line, begin.column,
                     fmt::format("The text that begins here with R\" never ends: its {} is missing.",
                                 end.empty() || end.size() > 20 ? ")\"" : end)};
        step(close == std::string_view::npos ? source_.size() - at_ : close + end.size() - at_);
        raw_ = false;
    }
    /// Digit separators, as in 1'000, open no character literal.
    void read_number() {
        begin_statement();
        while (at_ < source_.size() && (in_a_word(source_[at_]) || source_[at_] == '.' || source_[at_] == '\'')) step();
    }
    void read_word() {
        begin_statement();
        const std::size_t begin = at_;
        while (at_ < source_.size() && in_a_word(source_[at_])) step();
        const std::string_view word = source_.substr(begin, at_ - begin);
        raw_ = at_ < source_.size() && source_[at_] == '"' &&
               (word == "R" || word == "LR" || word == "uR" || word == "UR" || word == "u8R");
    }

    void read_sign(char c) {
        if (c == '{') open_brace();
        else if (c == '}') close_brace();
        else begin_statement();
        if (c == '(') ++statement_.parentheses;
        if (c == ')') --statement_.parentheses;
        if (c == ';' && statement_.parentheses <= 0) {
            if (!list_ && !is_dead() && !braces_.empty() && braces_.back().is_list)
                list_ = {braces_.back().spot.line, braces_.back().spot.column,
                         fmt::format("This {{ is never closed: its }} is missing before the ; of line {}.", line_)};
            statement_ = {};
        }
        step();
    }

    void begin_statement() {
        if (statement_.begin != std::string_view::npos) return;
        statement_.begin = at_;
        statement_.indentation = indentation();
        if (braces_.empty()) end_of_all_ = last_end_;
        if (!by_indentation_ || !is_first_in_line() || is_label()) return;
        while (!braces_.empty() && indentation() <= std::min(braces_.back().of_line, braces_.back().of_statement)) {
            const Brace& block = braces_.back();
            if (block.is_namespace || block.spot.line == line_) return;
            if (!missing_)
                missing_ = {block.spot.line, block.spot.column,
                            fmt::format("This {{ is never closed: its }} is missing before line {}.", line_)};
            braces_.pop_back();
        }
    }
    bool is_label() const {
        return std::ranges::any_of(std::vector<std::string_view>{"public", "private", "protected", "case", "default"},
                                   [&](std::string_view word) { return starts(word); });
    }

    void open_brace() {
        const bool alone = statement_.begin == std::string_view::npos;
        const std::string_view before = alone ? "" : source_.substr(statement_.begin, at_ - statement_.begin);
        const bool is_namespace = before.find("namespace ") != std::string_view::npos || before == "namespace" ||
                                  before.starts_with("extern \"");
        if (braces_.empty() && is_namespace) end_of_all_.reset();
        const std::string_view last = before.substr(0, before.find_last_not_of(" \t\r\n") + 1);
        const bool in_list = !braces_.empty() && braces_.back().is_list;  // a [ in it begins a function's body
        const bool is_list =
            in_list ? before.find('[') == std::string_view::npos : last.ends_with("return") || last.ends_with('=');
        braces_.push_back(
            {spot(), indentation(), alone ? indentation() : statement_.indentation, is_namespace, is_list});
        statement_ = {};
    }

    void close_brace() {
        statement_ = {};
        if (is_dead()) return;
        if (braces_.empty()) return surplus_.push_back(spot());
        const Brace& block = braces_.back();
        const bool is_right = is_first_in_line() && indentation() > std::max(block.of_line, block.of_statement);
        if (by_indentation_ && is_right) {
            const Spot here = spot();
            if (!too_many_) too_many_ = {here.line, here.column, "This } is one too many: it closes nothing."};
            return;
        }
        if (braces_.size() == 1 && block.is_namespace) last_end_ = spot();
        braces_.pop_back();
    }

    std::string_view source_;
    bool by_indentation_;
    std::size_t at_ = 0, line_ = 1, line_begin_ = 0;
    Statement statement_;
    std::vector<Brace> braces_;
    std::vector<Branches> branches_;
    std::vector<Spot> surplus_;
    std::optional<Unclosed> text_, comment_, list_, missing_, too_many_;
    std::optional<Spot> last_end_, end_of_all_;
    bool raw_ = false, cut_off_ = false;
};

}  // namespace

std::optional<Unclosed> unclosed_in(std::string_view source) {
    const Reading plain(source, false);
    if (plain.text()) return plain.text();
    if (plain.is_cut_off() || plain.is_even()) return {};
    if (plain.comment()) return plain.comment();
    if (plain.list()) return plain.list();
    const Reading by_indentation(source, true);
    if (by_indentation.is_even())
        return by_indentation.missing() ? by_indentation.missing() : by_indentation.too_many();
    if (!plain.open().empty()) {
        const Spot spot = plain.open().back().spot;
        return Unclosed{spot.line, spot.column, "This { is never closed: a } is missing, at the end or further up."};
    }
    const Spot last = plain.surplus().front();
    if (const std::optional<Spot> end = plain.end_of_all())
        return Unclosed{
            end->line, end->column,
            fmt::format("With this }} the namespace ends already, and the }} of line {} closes nothing: one }} "
                        "is too many, here or further up.",
                        last.line)};
    return Unclosed{last.line, last.column, "This } closes nothing: one } is too many, here or further up."};
}

}  // namespace glassbox::learn
