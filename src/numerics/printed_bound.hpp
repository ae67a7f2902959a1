#pragma once
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "numerics/decimal.hpp"

namespace glassbox {

// How a number and a bound on its error are printed: rounding must not make the bound a lie. All numbers are finite.

/// The shortest decimal that reads back to the same double.
inline std::string shortest(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific).ptr;
    return Decimal(std::string_view(text, static_cast<std::size_t>(end - text))).text();
}

/// A value with the digits that its bound deserves: down to the bound's second digit, but at least two, and no more
/// than tell any two doubles apart. Without an error all of its digits, or the shortest, if those are too many.
inline std::string value_beside(double value, double error) {
    constexpr int most = 17;
    const Decimal exact(value);
    const int first = exact.first_place();
    if (error == 0) return first - exact.last_place() < most ? exact.text() : shortest(value);
    const int place = Decimal(error).first_place() - 1;
    return exact.rounded(std::clamp(place, first - most + 1, first - 1)).text();
}

/// The bound for a value that was printed so: not below the error together with what the print is off. "0" if both are
/// nothing.
inline std::string bound_beside(std::string_view printed, double value, double error, int digits = 2) {
    const Decimal off = abs(Decimal(printed) - Decimal(value));
    return (Decimal(error) + off).rounded_up(digits).text();
}

/// The double to print in place of a bound, in the shortest form that reads back. That form is at least
/// as near to this double as to the bound, its neighbour below, and so is above the bound.
inline double bound_to_print(double error) {
    return error == 0 ? 0 : std::nextafter(error, std::numeric_limits<double>::infinity());
}

}  // namespace glassbox
