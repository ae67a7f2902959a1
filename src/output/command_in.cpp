#include "output/command_in.hpp"

#include <cstddef>
#include <cstdint>

namespace glassbox {

namespace {

/// Four bytes as a number, the first one the highest; 0 beyond the end.
std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t number = 0;
    for (const char byte : bytes.substr(0, 4)) number = number << 8 | static_cast<unsigned char>(byte);
    return number;
}

std::uint32_t little_endian(std::string_view bytes) {
    std::uint32_t number = 0;
    for (std::size_t i = 4; i-- > 0;)
        if (i < bytes.size()) number = number << 8 | static_cast<unsigned char>(bytes[i]);
    return number;
}

/// Takes what stands before the next zero byte, and that byte.
std::string_view taken_word(std::string_view& rest) {
    const std::size_t end = rest.find('\0');
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    return word;
}

/// Chunks: a length, a type, so many bytes, a checksum.
std::string in_png(std::string_view rest) {
    constexpr std::size_t around = 12, languages = 4;
    while (rest.size() > around) {
        const std::size_t size = big_endian(rest);
        const std::string_view type = rest.substr(4, 4);
        std::string_view data = rest.substr(8, size);
        if ((type == "tEXt" || type == "iTXt") && taken_word(data) == "Command") {
            if (type == "iTXt") data.remove_prefix(data.size() < languages ? data.size() : languages);
            return std::string(data);
        }
        if (size > rest.size() - around) break;
        rest.remove_prefix(around + size);
    }
    return {};
}

/// Attributes: a name, a type, a length, so many bytes.
std::string in_exr(std::string_view rest) {
    while (true) {
        const std::string_view name = taken_word(rest), type = taken_word(rest);
        if (name.empty() || rest.size() < 4) return {};
        const std::size_t size = little_endian(rest);
        rest.remove_prefix(4);
        if (name == "command" && type == "string") return std::string(rest.substr(0, size));
        if (size > rest.size()) return {};
        rest.remove_prefix(size);
    }
}

/// Comments, each a line, before the width.
std::string in_ppm(std::string_view rest) {
    constexpr std::string_view before = "# Command: ";
    while (rest.starts_with('#')) {
        const std::size_t end = rest.find('\n');
        if (end == std::string_view::npos) break;
        if (rest.starts_with(before)) return std::string(rest.substr(before.size(), end - before.size()));
        rest.remove_prefix(end + 1);
    }
    return {};
}

}  // namespace

std::string command_in(std::string_view file) {
    constexpr std::string_view png = "\x89PNG\r\n\x1a\n", ppm = "P6\n", exr = "\x76\x2f\x31\x01";
    constexpr std::size_t version = 4;  // of an EXR, after its magic number
    if (file.starts_with(png)) return in_png(file.substr(png.size()));
    if (file.starts_with(ppm)) return in_ppm(file.substr(ppm.size()));
    if (file.starts_with(exr) && file.size() > exr.size() + version) return in_exr(file.substr(exr.size() + version));
    return {};
}

}  // namespace glassbox
