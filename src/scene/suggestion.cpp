#include "scene/suggestion.hpp"

#include <algorithm>
#include <cctype>

namespace glassbox {

namespace {

std::string joined(const std::vector<std::string>& words, const char* before_last) {
    std::string text = words.front();
    for (std::size_t i = 1; i < words.size(); ++i) text += (i + 1 < words.size() ? ", " : before_last) + words[i];
    return text;
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
    const auto same = [](char x, char y) {
        return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
    };
    // d[i][j] for the first i letters of a and the first j of b.
    std::vector d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                d[i][j] = i + j;
                continue;
            }
            d[i][j] =
                std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (same(a[i - 1], b[j - 1]) ? 0 : 1)});
            if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]))
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    }
    return d[a.size()][b.size()];
}

std::string did_you_mean(std::string_view unknown, std::span<const std::string_view> known) {
    constexpr std::size_t longest = 100;  // longer names are no typing mistakes
    if (unknown.size() >= longest) return "";
    const auto nearest = std::min_element(known.begin(), known.end(), [&](auto a, auto b) {
        return edit_distance(unknown, a) < edit_distance(unknown, b);
    });
    if (nearest == known.end()) return "";
    const std::size_t most = (std::max(unknown.size(), nearest->size()) + 2) / 3;
    return edit_distance(unknown, *nearest) <= most ? "did you mean '" + std::string(*nearest) + "'?" : "";
}

std::string did_you_mean(std::string_view unknown, const std::vector<std::string>& known) {
    return did_you_mean(unknown, std::vector<std::string_view>(known.begin(), known.end()));
}

std::string counted(std::size_t count, std::string_view thing) {
    return std::to_string(count) + ' ' + std::string(thing) + (count == 1 ? "" : "s");
}

std::string either(const std::vector<std::string>& words) { return joined(words, " or "); }
std::string enumerated(const std::vector<std::string>& words) { return joined(words, " and "); }

std::string suggestion(std::string_view unknown, std::span<const std::string_view> known) {
    std::string near = did_you_mean(unknown, known);
    if (!near.empty()) return near;
    std::string names;
    for (const auto name : known) names += (names.empty() ? "'" : ", '") + std::string(name) + "'";
    return "it must be one of " + names;
}

}  // namespace glassbox
