#include "scene/rays_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "scene/error.hpp"
#include "scene/number_field.hpp"
#include "scene/text_file.hpp"

namespace glassbox {

namespace {

constexpr std::string_view header = "ox,oy,oz,dx,dy,dz";

/// A line without the carriage return that Windows ends it with.
std::string_view without_return(std::string_view line) {
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

Ray<double> read_ray(std::string_view line, Place place) {
    std::array<double, 6> numbers{};
    std::size_t count = 0;
    for (std::size_t begin = 0; begin <= line.size(); ++count) {
        const std::size_t end = std::min(line.find(',', begin), line.size());
        if (count <= numbers.size()) place.column = begin + 1;  // of the first field too many, if there are any
        if (count < numbers.size()) numbers[count] = read_number(line.substr(begin, end - begin), place);
        begin = end + 1;
    }
    if (count != numbers.size())
        throw error_at(place, fmt::format("{} numbers in this row; a ray has 6: {}", count, header));
    const auto& [ox, oy, oz, dx, dy, dz] = numbers;
    return {{ox, oy, oz}, {dx, dy, dz}};
}

/// Whether the line is the header; spaces around names do not count, as around numbers.
bool is_header(std::string_view line) {
    std::string names(line);
    names.erase(std::remove(names.begin(), names.end(), ' '), names.end());
    return names == header;
}

}  // namespace

std::vector<Ray<double>> read_rays(const std::filesystem::path& file) {
    const std::string content = read_lines(file);
    const std::string_view text = content;
    std::vector<Ray<double>> rays;
    Place place{file.string(), 1, 1};
    for (std::size_t begin = 0; begin < text.size() || place.line == 1; ++place.line) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = without_return(text.substr(begin, end - begin));
        if (place.line == 1) {
            if (!is_header(line)) throw error_at(place, fmt::format("the first line must be the header {}", header));
        } else if (!trimmed(line).empty()) {
            rays.push_back(read_ray(line, place));
        }
        begin = end + 1;
    }
    return rays;
}

}  // namespace glassbox
