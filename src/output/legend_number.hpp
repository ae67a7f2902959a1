#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace glassbox {

/// A number for a legend, with that many significant digits: "471.2", "−0.05", "1.5×10³⁰⁰", "∞". Whole numbers below
/// 10⁹ keep all their digits.
std::string legend_number(double value, int digits = 4);

/// How many digits tell numbers in [low, high] apart, and at least 4.
int digits_between(double low, double high);

/// "1 pixel", "5 pixels".
std::string pixels(std::int64_t count);

/// "3.5 |D|"
std::string with_unit(const std::string& number, std::string_view unit);

struct Tick {
    double value;
    std::string label;
};

/// At most `most` marks from low to high, at whole multiples of 1, 2 or 5 times a power of ten; only at whole numbers
/// if `whole`. None where floating point leaves no room for them.
std::vector<Tick> ticks(double low, double high, int most, bool whole);

}  // namespace glassbox
