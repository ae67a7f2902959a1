#include "output/value_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "output/legend_number.hpp"

namespace glassbox {

namespace {

/// The word for a value that stands for one, or none.
std::string_view word_of(const Measurement& what, double value) {
    const auto words = static_cast<double>(what.words.size());
    if (!(value >= 0 && value < words) || value != std::floor(value)) return {};
    return what.words[static_cast<std::size_t>(value)];
}

std::string infinite_in_words(const Measurement& what, double value) {
    const std::string_view meaning = value > 0 ? what.infinity : what.minus_infinity;
    return meaning.empty() ? legend_number(value) : fmt::format("{} ({})", legend_number(value), meaning);
}

}  // namespace

std::string value_in_words(const Measurement& what, double value, int digits) {
    if (std::isnan(value)) return "no value";
    if (std::isinf(value)) return infinite_in_words(what, value);
    if (const std::string_view word = word_of(what, value); !word.empty()) return std::string(word);
    return with_unit(legend_number(value, digits), what.unit);
}

std::string value_in_short(const Measurement& what, double value) {
    if (std::isnan(value)) return "–";
    const std::string_view word = word_of(what, value);
    return word.empty() ? legend_number(value) : std::string(word);
}

std::vector<std::string> value_in_lines(const Measurement& what, double value) {
    std::istringstream words(value_in_short(what, value));
    std::vector<std::string> lines;
    for (std::string word; words >> word;) lines.push_back(word);
    return lines;
}

std::vector<ColorWord> color_words(const Measurement& what, const Channel& channel, const Summary& summary,
                                   const Coloring& coloring) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<ColorWord> all;
    for (std::size_t i = 0; i < what.words.size(); ++i) {
        const auto value = static_cast<double>(i);
        all.push_back({coloring(value), std::string(what.words[i]), std::ranges::count(channel.values, value)});
    }
    const auto add = [&](std::int64_t count, Rgb color, const std::string& text) {
        if (count > 0) all.push_back({color, text, count});
    };
    if (what.scale == Scale::difference) {
        const auto signs = [&](auto is_so) { return std::ranges::count_if(channel.values, is_so); };
        all.push_back({coloring(0), "0: no difference", signs([](double v) { return v == 0; })});
        add(signs([](double v) { return v > 0 && std::isfinite(v); }), coloring.at(0.8), "positive");
        add(signs([](double v) { return v < 0 && std::isfinite(v); }), coloring.at(0.2), "negative");
    }
    if (what.alarm == Alarm::below_0)
        add(std::ranges::count_if(channel.values, [](double v) { return v < 0 && std::isfinite(v); }),
            coloring(std::max(-1.0, coloring.low)), "below 0: not decided");
    if (what.scale == Scale::direction) return {{no_value_color, "no value", summary.missing}};
    const auto [low, high] = coloring.limits();
    const auto [below, above] = outside(channel, coloring);
    add(below, coloring(std::nextafter(low, -infinity)), "below " + legend_number(low));
    add(above, coloring(std::nextafter(high, infinity)), "above " + legend_number(high));
    add(summary.negative_infinite, coloring(-infinity), infinite_in_words(what, -infinity));
    add(summary.positive_infinite, coloring(infinity), infinite_in_words(what, infinity));
    all.push_back({no_value_color, "no value", summary.missing});
    return all;
}

std::string spacing_in_words(Spacing spacing) {
    switch (spacing) {
        case Spacing::linear:
            return "";
        case Spacing::log:
            return "on a logarithmic scale";
        case Spacing::symlog:
            return "on a symmetric logarithmic scale";
        case Spacing::percentile:
            return "by percentiles: each colour has as many pixels";
    }
    return "";
}

}  // namespace glassbox
