#include "output/ppm.hpp"

#include <fmt/core.h>

#include <span>
#include <string>

namespace glassbox {

std::vector<std::byte> ppm(const Image& image, const Origin& origin) {
    std::string header = "P6\n";
    for (const auto& [name, text] : notes_of(origin)) header += fmt::format("# {}: {}\n", name, text);
    header += fmt::format("{} {}\n255\n", image.width, image.height);
    const auto head = std::as_bytes(std::span(header));
    const auto body = std::as_bytes(std::span(image.pixels));
    std::vector<std::byte> bytes;
    bytes.reserve(head.size() + body.size());
    bytes.insert(bytes.end(), head.begin(), head.end());
    bytes.insert(bytes.end(), body.begin(), body.end());
    return bytes;
}

}  // namespace glassbox
