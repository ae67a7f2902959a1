#include "cli/typed.hpp"

#include <charconv>
#include <cmath>
#include <optional>

#include "render/option_names.hpp"
#include "scene/scene.hpp"

namespace glassbox {

namespace {

template <class Number>
std::optional<Number> number(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return {};
    return value;
}

std::optional<Turn<double>> turn(std::string_view text) {
    const bool has_axis = text.size() > 2 && text[0] >= 'x' && text[0] <= 'z' && text[1] == ':';
    std::string_view angle = has_axis ? text.substr(2) : std::string_view{};
    if (angle.size() > 1 && angle[0] == '+' && angle[1] != '-') angle.remove_prefix(1);
    const std::optional<double> degrees = number<double>(angle);
    if (!degrees || !std::isfinite(*degrees)) return {};
    return Turn<double>{static_cast<Axis>(text[0] - 'x'), *degrees};
}

}  // namespace

CLI::ValidationError wrong(std::string_view option, const std::string& message) {
    return CLI::ValidationError(std::string(option), message);
}

int whole_number(std::string_view option, const std::string& typed, int least, int most) {
    const std::optional<int> value = number<int>(typed);
    if (!value || *value < least || *value > most)
        throw wrong(option, fmt::format("'{}' must be a whole number from {} to {}", typed, least, most));
    return *value;
}

double factor(std::string_view option, const std::string& typed) {
    const std::optional<double> value = number<double>(typed);
    if (!value || !std::isfinite(*value) || *value < 0)
        throw wrong(option, fmt::format("'{}' must be a number, 0 or more", typed));
    return *value;
}

std::pair<int, int> size(std::string_view option, const std::string& typed) {
    const std::size_t cross = typed.find_first_of("xX");
    const auto side = [&](std::size_t from, std::size_t to) { return number<long long>(typed.substr(from, to)); };
    const auto width = cross == std::string::npos ? std::nullopt : side(0, cross);
    const auto height = cross == std::string::npos ? std::nullopt : side(cross + 1, std::string::npos);
    if (!width || !height)
        throw wrong(option, fmt::format("'{}' must be WIDTHxHEIGHT in pixels, such as 800x600", typed));
    if (*width < 1 || *height < 1 || *width > max_side || *height > max_side || *width * *height > max_pixels)
        throw wrong(option, fmt::format("{} must be from 1 to {} pixels a side, and at most {} in all", typed, max_side,
                                        max_pixels));
    return {static_cast<int>(*width), static_cast<int>(*height)};
}

std::vector<Turn<double>> turns(std::string_view option, const std::string& typed) {
    std::vector<Turn<double>> result;
    for (const std::string& one : between_commas(typed)) {
        const std::optional<Turn<double>> read = turn(one);
        if (!read)
            throw wrong(option, fmt::format("'{}' must be an axis, x, y or z, and degrees, such as z:10 or z:10,y:-20",
                                            one.empty() ? typed : one));
        result.push_back(*read);
    }
    return result;
}

TriangleRule triangle_rule(std::string_view option, const std::string& typed) {
    if (const auto tolerance = tolerance_text(typed))
        return Tolerance{
            factor(fmt::format("{} {}", option, name_of(TriangleRule(Tolerance{}))), std::string(*tolerance))};
    return chosen(option, typed, triangle_rules);
}

std::vector<std::string> between_commas(const std::string& typed) {
    std::vector<std::string> words(1);
    for (const char c : typed)
        if (c == ',') words.emplace_back();
        else words.back() += c;
    return words;
}

}  // namespace glassbox
