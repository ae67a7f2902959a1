#include "numerics/printed_bound.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "numerics/decimal.hpp"

namespace glassbox {

std::string shortest(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific).ptr;
    return Decimal(std::string_view(text, static_cast<std::size_t>(end - text))).text();
}

bool is_shortest(std::string_view printed, double value) { return Decimal(printed).text() == shortest(value); }

std::string rounded_up(double value, int digits) { return Decimal(value).rounded_up(digits).text(); }

std::string value_beside(double value, double error) {
    constexpr int most = 17;
    const Decimal exact(value);
    const int first = exact.first_place();
    if (error == 0) return first - exact.last_place() < most ? exact.text() : shortest(value);
    const int place = Decimal(error).first_place() - 1;
    return exact.rounded(std::clamp(place, first - most + 1, first - 1)).text();
}

std::string bound_beside(std::string_view printed, double value, double error, int digits) {
    const Decimal off = abs(Decimal(printed) - Decimal(value));
    return (Decimal(error) + off).rounded_up(digits).text();
}

double bound_to_print(double error) {
    return error == 0 ? 0 : std::nextafter(error, std::numeric_limits<double>::infinity());
}

}  // namespace glassbox
