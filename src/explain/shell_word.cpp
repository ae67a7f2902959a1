#include "explain/shell_word.hpp"

namespace glassbox {

std::string shell_word(const std::string& word) {
    constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string result = "'";
    for (const char c : word)
        if (c == '\'') result += "'\\''";
        else result += c;
    return result + '\'';
}

}  // namespace glassbox
