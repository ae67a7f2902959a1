#include "scene/printable.hpp"

#include "scene/utf8.hpp"

namespace glassbox {

namespace {

/// Whether it is a control character: C0, delete or C1. U+009B, for one, begins a command, as escape and [ do.
bool is_control(char32_t c) { return c < 0x20 || (c >= 0x7F && c < 0xA0); }

/// Whether it is one of Unicode's Bidi_Control: the text after it may be shown in another order than it is read.
bool turns_direction(char32_t c) {
    return c == 0x61C || c == 0x200E || c == 0x200F || (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
}

/// Whether it is one of Unicode's own line ends.
bool ends_line(char32_t c) { return c == 0x2028 || c == 0x2029; }

std::string printable_but_for(std::string_view text, std::string_view kept) {
    std::string shown;
    shown.reserve(text.size());
    while (!text.empty()) {
        const auto [code, size] = first_character(text);
        const bool good = code && !is_control(*code) && !turns_direction(*code) && !ends_line(*code);
        if (good || kept.find(text.front()) != std::string_view::npos) shown += text.substr(0, size);
        else shown += '?';
        text.remove_prefix(size);
    }
    return shown;
}

}  // namespace

std::string printable(std::string_view text) { return printable_but_for(text, ""); }

std::string printable_lines(std::string_view text) { return printable_but_for(text, "\n\t"); }

}  // namespace glassbox
