#include "output/ppm.hpp"

#include <fmt/core.h>

#include <span>

namespace glassbox {

std::vector<std::byte> ppm(const Image& image) {
    const std::string header = fmt::format("P6\n{} {}\n255\n", image.width, image.height);
    const auto head = std::as_bytes(std::span(header));
    const auto body = std::as_bytes(std::span(image.pixels));
    std::vector<std::byte> bytes;
    bytes.reserve(head.size() + body.size());
    bytes.insert(bytes.end(), head.begin(), head.end());
    bytes.insert(bytes.end(), body.begin(), body.end());
    return bytes;
}

}  // namespace glassbox
