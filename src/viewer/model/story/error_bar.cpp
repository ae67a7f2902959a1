#include "viewer/model/story/error_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "numerics/decimal.hpp"

namespace glassbox {

namespace {

/// The largest distance of a position from 0, and how much of it a magnified bar takes.
constexpr double half_width = .45, magnified_half = .07;
/// A bound below this part of the value would be too thin to be seen.
constexpr double least_visible = .02;

/// The least n with bound < 10ⁿ |value|.
int power_above(double error, double value) {
    const Decimal bound(error), size = abs(Decimal(value));
    int n = bound.first_place() - size.first_place() + 1;
    while (!(Decimal::power_of_ten(n - 1) * size <= bound)) --n;
    return n;
}

/// The least whole number of percent that is not below the bound.
int percent_above(double error, double value) {
    const Decimal bound = Decimal(error) * Decimal(100.0), size = abs(Decimal(value));
    int percent = 0;
    while (!(bound <= Decimal(1.0 * percent) * size)) ++percent;
    return percent;
}

}  // namespace

std::string power_of_ten(int exponent) {
    constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "10⁻" : "10";
    for (const char digit : std::to_string(std::abs(exponent))) text += digits[digit - '0'];
    return text;
}

ErrorBar error_bar(const story::Number& number) {
    ErrorBar bar;
    const double value = number.value, error = number.error;
    if (!std::isfinite(value)) {
        bar.words = "not finite: no place on a line";
        return bar;
    }
    if (!std::isfinite(error)) {
        bar.value = value == 0 ? .5 : .5 + std::copysign(half_width, value) / 2;
        bar.low = 0;
        bar.high = 1;
        bar.words = "no bound is proven";
        return bar;
    }
    bar.sign_is_proven = error == 0 || std::abs(value) > error;
    if (error == 0) {
        bar.kind = ErrorBar::Kind::exact;
        bar.value = bar.low = bar.high = value == 0 ? .5 : .5 + std::copysign(half_width, value);
        bar.words = value == 0 ? "exactly 0" : "exact";
        return bar;
    }
    const bool magnified = error < least_visible * std::abs(value);
    const double longest = std::abs(value) / 2 + error / 2;  // halves: the sum may be too large for a double
    double half = magnified_half;
    if (magnified) {
        bar.kind = ErrorBar::Kind::magnified;
        bar.value = .5 + std::copysign(half_width - magnified_half, value);
    } else {
        bar.kind = ErrorBar::Kind::to_scale;
        bar.value = .5 + half_width * (value / 2 / longest);
        half = half_width * (error / 2 / longest);
    }
    bar.low = bar.value - half;
    bar.high = bar.value + half;
    if (number.known != Known::not_at_all) {
        const double off = std::clamp(number.distance / error, 0.0, 1.0);
        bar.truth = bar.value + (number.truth < value ? -off : off) * half;
    }
    if (!bar.sign_is_proven) bar.words = "0 lies within the bound: the sign is not proven by it";
    else if (magnified) bar.words = fmt::format("bound < {} of the value", power_of_ten(power_above(error, value)));
    else bar.words = fmt::format("bound ≤ {} % of the value", percent_above(error, value));
    return bar;
}

}  // namespace glassbox
