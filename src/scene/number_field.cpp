#include "scene/number_field.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>

#include "scene/text_file.hpp"

namespace glassbox {

double read_number(std::string_view field, const Place& place) {
    const std::string_view digits = trimmed(field);
    double value = 0;
    const auto [rest, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (problem == std::errc{} && rest == digits.data() + digits.size()) return value;

    const std::string text(digits);  // as strtod reads it, hexadecimal ("0x1.8p3") too
    char* end = nullptr;
    errno = 0;
    value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0')
        throw error_at(place, fmt::format("{} is not a number; write one such as 0.5, 1e-3, 0x1.8p3, nan or inf",
                                          in_quotes(text)));
    if (errno == ERANGE && std::isinf(value))
        throw error_at(place, fmt::format("{} is too large for a double; write inf if that is meant", in_quotes(text)));
    return value;
}

}  // namespace glassbox
