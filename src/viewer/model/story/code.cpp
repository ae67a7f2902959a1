#include "viewer/model/story/code.hpp"

#include <algorithm>

namespace glassbox {

namespace {

constexpr std::string_view keywords[] = {
    "auto",     "bool",     "case",   "char",     "class",    "const",       "constexpr", "decltype",
    "default",  "double",   "else",   "enum",     "explicit", "false",       "float",     "for",
    "friend",   "if",       "inline", "int",      "long",     "namespace",   "operator",  "private",
    "public",   "requires", "return", "sizeof",   "static",   "static_cast", "struct",    "switch",
    "template", "this",     "true",   "typename", "unsigned", "using",       "void",      "while",
};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// How long the piece is that a text, not empty, begins with.
std::size_t length_of_piece(std::string_view text, CodeKind& kind) {
    const auto while_true = [&](std::size_t from, const auto& goes_on) {
        while (from < text.size() && goes_on(from)) ++from;
        return from;
    };
    const char first = text[0];
    if (text.starts_with("//")) {
        kind = CodeKind::comment;
        return text.size();
    }
    if (first == '#') {
        kind = CodeKind::keyword;
        return while_true(1, [&](std::size_t i) { return is_letter(text[i]); });
    }
    if (is_letter(first)) {
        const std::size_t end = while_true(1, [&](std::size_t i) { return is_letter(text[i]) || is_digit(text[i]); });
        kind = std::ranges::find(keywords, text.substr(0, end)) != std::end(keywords) ? CodeKind::keyword
                                                                                      : CodeKind::plain;
        return end;
    }
    if (is_digit(first)) {
        kind = CodeKind::number;
        return while_true(1, [&](std::size_t i) {
            const char c = text[i];
            const bool sign = (c == '-' || c == '+') && (text[i - 1] == 'e' || text[i - 1] == 'p');
            return is_letter(c) || is_digit(c) || c == '.' || c == '\'' || sign;
        });
    }
    if (first == '"') {
        kind = CodeKind::text;
        const std::size_t end = text.find('"', 1);
        return end == std::string_view::npos ? text.size() : end + 1;
    }
    kind = CodeKind::plain;
    return while_true(1, [&](std::size_t i) {
        return !is_letter(text[i]) && !is_digit(text[i]) && text[i] != '"' && text[i] != '#' && text[i] != '/';
    });
}

/// Cuts a piece after each blank.
std::vector<CodePiece> cut_at_blanks(const std::vector<CodePiece>& pieces) {
    std::vector<CodePiece> cut;
    for (auto [kind, text] : pieces)
        while (!text.empty()) {
            const std::size_t blank = text.find(' ');
            const std::size_t end = blank == std::string_view::npos ? text.size() : blank + 1;
            cut.push_back({kind, text.substr(0, end)});
            text.remove_prefix(end);
        }
    return cut;
}

}  // namespace

std::size_t columns_of(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::vector<CodePiece> code_pieces(std::string_view line) {
    std::vector<CodePiece> pieces;
    while (!line.empty()) {
        CodePiece piece;
        piece.text = line.substr(0, length_of_piece(line, piece.kind));
        line.remove_prefix(piece.text.size());
        pieces.push_back(piece);
    }
    return pieces;
}

std::vector<CodeRow> code_rows(std::string_view line, std::size_t columns) {
    const std::size_t blanks = std::min(line.find_first_not_of(' '), line.size());
    std::vector<CodeRow> rows{{blanks, {}}};
    std::size_t used = blanks;
    bool breakable = false;  // the row ends with a blank
    // What stands between two blanks goes to the next row as a whole.
    std::vector<CodePiece> word;
    std::size_t width = 0;
    const auto put = [&] {
        if (breakable && used + width > columns) {
            rows.push_back({std::min(blanks + 4, columns / 2), {}});
            used = rows.back().indent;
        }
        for (const CodePiece& piece : word) rows.back().pieces.push_back(piece);
        used += width;
        breakable = true;
        word.clear();
        width = 0;
    };
    for (const CodePiece& piece : cut_at_blanks(code_pieces(line.substr(blanks)))) {
        word.push_back(piece);
        width += columns_of(piece.text) - (piece.text.ends_with(' ') ? 1 : 0);
        if (!piece.text.ends_with(' ')) continue;
        put();
        ++used;  // the blank itself may stand beyond the last column
    }
    if (!word.empty()) put();
    return rows;
}

}  // namespace glassbox
