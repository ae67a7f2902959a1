#include "viewer/script/words.hpp"

#include <fmt/format.h>

#include "scene/error.hpp"
#include "scene/text_file.hpp"

namespace glassbox::script {

Words words_of(std::string_view line) {
    constexpr std::string_view blanks = " \t\r\f\v";
    Words words;
    bool in_word = false;
    for (std::size_t at = 0; at < line.size(); ++at) {
        const char c = line[at];
        if (c == '#') break;
        if (blanks.find(c) != std::string_view::npos) {
            in_word = false;
            continue;
        }
        const bool is_quoted = !in_word && (c == '"' || c == '\'');
        if (!in_word) words.emplace_back();
        in_word = true;
        if (!is_quoted) {
            words.back() += c;
            continue;
        }
        const std::size_t end = line.find(c, at + 1);
        if (end == std::string_view::npos)
            throw Error(fmt::format("the quote {} is not closed; it must be closed on the same line",
                                    in_quotes(line.substr(at))));
        words.back() += line.substr(at + 1, end - at - 1);
        at = end;
    }
    return words;
}

}  // namespace glassbox::script
