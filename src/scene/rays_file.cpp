#include "scene/rays_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>

#include "scene/error.hpp"
#include "scene/text_file.hpp"

namespace glassbox {

namespace {

constexpr std::string_view header = "ox,oy,oz,dx,dy,dz";

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// One number, decimal or hexadecimal ("0x1.8p3", which std::from_chars would not take).
double read_number(std::string_view field, const Place& place) {
    const std::string text(trimmed(field));
    char* end = nullptr;
    errno = 0;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0')
        throw error_at(place,
                       fmt::format("'{}' is not a number; write one such as 0.5, 1e-3, 0x1.8p3, nan or inf", text));
    if (errno == ERANGE && std::isinf(value))
        throw error_at(place, fmt::format("{} is too large for a double; write inf if that is meant", text));
    return value;
}

Ray<double> read_ray(std::string_view line, Place place) {
    std::array<double, 6> numbers{};
    std::size_t count = 0;
    for (std::size_t begin = 0; begin <= line.size(); ++count) {
        const std::size_t end = std::min(line.find(',', begin), line.size());
        place.column = begin + 1;
        if (count < numbers.size()) numbers[count] = read_number(line.substr(begin, end - begin), place);
        begin = end + 1;
    }
    place.column = 1;
    if (count != numbers.size())
        throw error_at(place, fmt::format("{} numbers in this row; a ray has 6: {}", count, header));
    const auto& [ox, oy, oz, dx, dy, dz] = numbers;
    return {{ox, oy, oz}, {dx, dy, dz}};
}

}  // namespace

std::vector<Ray<double>> read_rays(const std::filesystem::path& file) {
    const std::string text = read_text(file);
    std::vector<Ray<double>> rays;
    Place place{file.string(), 1, 1};
    for (std::size_t begin = 0; begin < text.size() || place.line == 1; ++place.line) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = trimmed(std::string_view(text).substr(begin, end - begin));
        if (place.line == 1) {
            if (line != header) throw error_at(place, fmt::format("the first line must be the header {}", header));
        } else if (!line.empty()) {
            rays.push_back(read_ray(line, place));
        }
        begin = end + 1;
    }
    return rays;
}

}  // namespace glassbox
