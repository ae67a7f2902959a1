#include "scene/shell_word.hpp"

#include <fmt/format.h>

#include <string_view>

#include "scene/printable.hpp"
#include "scene/utf8.hpp"

namespace glassbox {

namespace {

std::string in_single_quotes(std::string_view word) {
    std::string result = "'";
    for (const char c : word)
        if (c == '\'') result += "'\\''";
        else result += c;
    return result + '\'';
}

/// $'…', in which bytes can be written as octal numbers: in POSIX since 2024, and always in bash and zsh.
std::string in_dollar_quotes(std::string_view word) {
    std::string result = "$'";
    while (!word.empty()) {
        const std::string_view character = word.substr(0, first_character(word).size);
        if (character == "'" || character == "\\") result.append("\\").append(character);
        else if (printable(character) == character) result += character;
        else
            for (const char byte : character) result += fmt::format("\\{:03o}", static_cast<unsigned char>(byte));
        word.remove_prefix(character.size());
    }
    return result + '\'';
}

}  // namespace

std::string shell_word(const std::string& word) {
    constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    return printable(word) == word ? in_single_quotes(word) : in_dollar_quotes(word);
}

}  // namespace glassbox
