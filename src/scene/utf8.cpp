#include "scene/utf8.hpp"

#include <algorithm>

namespace glassbox {

Utf8Character first_character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned lead = byte(0);
    const std::size_t size = lead < 0x80   ? 1
                             : lead < 0xC2 ? 0
                             : lead < 0xE0 ? 2
                             : lead < 0xF0 ? 3
                             : lead < 0xF5 ? 4
                                           : 0;
    if (size == 0 || size > text.size()) return {};
    char32_t code = size == 1 ? lead : lead & (0x7Fu >> size);
    for (std::size_t k = 1; k < size; ++k) {
        if ((byte(k) & 0xC0u) != 0x80u) return {};
        code = code << 6 | (byte(k) & 0x3Fu);
    }
    // Overlong, a surrogate, or beyond Unicode's end.
    if ((size == 3 && code < 0x800) || (size == 4 && code < 0x10000)) return {};
    if ((code >= 0xD800 && code < 0xE000) || code > 0x10FFFF) return {};
    return {code, size};
}

std::size_t columns(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }));
}

}  // namespace glassbox
