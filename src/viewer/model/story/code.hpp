#pragma once
#include <cstddef>
#include <string_view>
#include <vector>

namespace glassbox {

/// What a piece of C++ is, for its colour.
enum class CodeKind { plain, keyword, number, text, comment };

struct CodePiece {
    CodeKind kind = CodeKind::plain;
    std::string_view text;

    bool operator==(const CodePiece&) const = default;
};

/// Returns the pieces of a line, blanks included: joined they are the line.
std::vector<CodePiece> code_pieces(std::string_view line);

/// A row of a line that is broken to fit.
struct CodeRow {
    std::size_t indent = 0;  ///< columns
    std::vector<CodePiece> pieces;
};

/// Breaks a line at blanks into rows of at most so many columns; a piece without a blank may be wider. Later rows stand
/// four columns further in than the first.
std::vector<CodeRow> code_rows(std::string_view line, std::size_t columns);

/// How many characters a text in UTF-8 has.
std::size_t columns_of(std::string_view text);

}  // namespace glassbox
