#include "learn/build/first_error.hpp"

#include <string_view>

#include "scene/printable.hpp"

namespace glassbox::learn {

std::string with_caret(const CompileError& error) {
    const std::string before = printable_lines(std::string_view(error.source).substr(0, error.place.column - 1));
    std::string caret;
    for (const char c : error.place.column == 0 ? "" : before) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte & 0xC0u) != 0x80u) caret += byte == '\t' ? '\t' : ' ';  // a character of many bytes is one wide
    }
    return printable_lines(error.source) + '\n' + caret + '^';
}

}  // namespace glassbox::learn
