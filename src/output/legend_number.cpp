#include "output/legend_number.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace glassbox {
namespace {

int decimal_exponent(double value) {
    return value == 0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value))));
}

std::string superscript(int number) {
    static constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = number < 0 ? "⁻" : "";
    for (const char c : std::to_string(std::abs(number))) text += digits[c - '0'];
    return text;
}

/// The least of 1, 2, 5, 10, 20, … (with powers of ten below 1, too) that is not less than `least`.
double nice_step(double least) {
    const double power = std::pow(10, decimal_exponent(least));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least) return factor * power;
    return 10 * power;
}

}  // namespace

std::string legend_number(double value, int digits) {
    if (std::isnan(value)) return "no value";
    const std::string sign = value < 0 ? "−" : "";
    const double size = std::abs(value);
    if (std::isinf(size)) return sign + "∞";
    if (size == std::floor(size) && size < 1e9) return sign + fmt::format("{:.0f}", size);

    const int before_point = decimal_exponent(size) + 1;
    const std::string text = fmt::format("{:.{}g}", size, before_point <= 6 ? std::max(digits, before_point) : digits);
    const std::size_t e = text.find('e');
    if (e == std::string::npos) return sign + text;
    const std::string mantissa = text.substr(0, e);
    return sign + (mantissa == "1" ? "" : mantissa + "×") + "10" + superscript(std::atoi(text.c_str() + e + 1));
}

int digits_between(double low, double high) {
    const double largest = std::max(std::abs(low), std::abs(high));
    if (!(high > low)) return 6;
    if (std::isinf(high - low)) return 4;
    return std::clamp(decimal_exponent(largest) - decimal_exponent(high - low) + 3, 4, 17);
}

std::string pixels(std::int64_t count) { return count == 1 ? "1 pixel" : fmt::format("{} pixels", count); }

std::string with_unit(const std::string& number, std::string_view unit) {
    return unit.empty() ? number : fmt::format("{} {}", number, unit);
}

std::vector<Tick> ticks(double low, double high, int most, bool whole) {
    const double range = high - low;
    if (!(range > 0) || !std::isfinite(range) || most < 1) return {};
    double step = nice_step(range / most);
    if (whole) step = std::max(step, 1.0);
    const double first = std::ceil(low / step), last = std::floor(high / step);
    // Beyond 2^53 doubles cannot count multiples one by one, and a step may underflow to 0.
    if (!(std::abs(first) < 0x1p53 && std::abs(last) < 0x1p53)) return {};

    const int digits =
        std::clamp(decimal_exponent(std::max(std::abs(low), std::abs(high))) - decimal_exponent(step) + 1, 1, 17);
    std::vector<Tick> all;
    for (double k = first; k <= last; ++k) {
        const double value = k * step + 0.0;  // + 0.0: -0 becomes 0
        all.push_back({value, legend_number(value, digits)});
    }
    return all;
}

}  // namespace glassbox
