#include "scene/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "scene/error.hpp"
#include "scene/printable.hpp"
#include "scene/utf8.hpp"

namespace glassbox {

std::optional<std::string> why_unreadable(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (status.type() == std::filesystem::file_type::not_found) return "there is no such file";
    if (std::filesystem::is_directory(status)) return "it is a directory, not a file";
    errno = 0;
    if (!std::ifstream(file)) return "it cannot be read: " + std::generic_category().message(errno);
    return std::nullopt;
}

std::string read_text(const std::filesystem::path& file) {
    const Place place{file.string()};
    if (const auto reason = why_unreadable(file)) throw error_at(place, *reason);
    std::ifstream in(file, std::ios::binary);
    std::string text;
    // Checks each piece before it reads the next, and so refuses an endless device, too.
    std::array<char, 1 << 16> piece;
    while (in.read(piece.data(), piece.size()), in.gcount() > 0) {
        const auto end = piece.begin() + in.gcount();
        if (std::find(piece.begin(), end, '\0') != end)
            throw error_at(place, "this is a binary file; it must be a text file");
        text.append(piece.begin(), end);
    }
    if (in.bad()) throw error_at(place, "reading stopped halfway: " + std::generic_category().message(errno));
    return text;
}

std::string read_lines(const std::filesystem::path& file) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    std::string text = read_text(file);
    if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
    bool before_newline = false;
    for (auto at = text.rbegin(); at != text.rend(); ++at) {
        if (*at == '\r' && !before_newline) *at = '\n';
        else before_newline = *at == '\n' || *at == '\r';
    }
    return text;
}

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_last_not_of(blanks) + 1);
}

std::optional<std::size_t> first_not_utf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto [code, size] = first_character(text.substr(i));
        if (!code) return i;
        i += size;
    }
    return std::nullopt;
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t most = 60;
    std::size_t size = std::min(text.size(), most);
    if (size < text.size())  // not in the middle of a character
        while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0u) == 0x80u) --size;
    return fmt::format("'{}{}", printable(text.substr(0, size)), size < text.size() ? "…'" : "'");
}

}  // namespace glassbox
