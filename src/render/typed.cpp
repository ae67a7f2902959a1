#include "render/typed.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <type_traits>

#include "render/option_names.hpp"
#include "scene/direction.hpp"
#include "scene/scene.hpp"

namespace glassbox {

namespace {

template <class Number>
std::optional<Number> read(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return {};
    return value;
}

std::optional<Turn<double>> turn(std::string_view text) {
    const bool has_axis = text.size() > 2 && text[0] >= 'x' && text[0] <= 'z' && text[1] == ':';
    std::string_view angle = has_axis ? text.substr(2) : std::string_view{};
    if (angle.size() > 1 && angle[0] == '+' && angle[1] != '-') angle.remove_prefix(1);
    const std::optional<double> degrees = read<double>(angle);
    if (!degrees || !std::isfinite(*degrees)) return {};
    return Turn<double>{static_cast<Axis>(text[0] - 'x'), *degrees};
}

}  // namespace

WrongWord wrong(std::string_view option, const std::string& message) {
    return WrongWord(fmt::format("{}: {}", option, message));
}

int whole_number(std::string_view option, const std::string& typed, int least, int most) {
    const std::optional<int> value = read<int>(typed);
    if (!value || *value < least || *value > most)
        throw wrong(option, fmt::format("'{}' must be a whole number from {} to {}", typed, least, most));
    return *value;
}

double number(std::string_view option, const std::string& typed, double least, double most) {
    const std::optional<double> value = read<double>(typed);
    if (!value || !(*value >= least && *value <= most))
        throw wrong(option, fmt::format("'{}' must be a number from {} to {}", typed, least, most));
    return *value;
}

double factor(std::string_view option, const std::string& typed) {
    const std::optional<double> value = read<double>(typed);
    if (!value || !std::isfinite(*value) || *value < 0)
        throw wrong(option, fmt::format("'{}' must be a number, 0 or more", typed));
    return *value;
}

Vec3<double> direction(std::string_view option, const std::string& typed) {
    const std::vector<std::string> words = between_commas(typed);
    std::vector<double> xyz;
    for (const std::string& word : words)
        if (const std::optional<double> value = read<double>(word); value && std::isfinite(*value))
            xyz.push_back(*value);
    if (words.size() != 3 || xyz.size() != 3)
        throw wrong(option, fmt::format("'{}' must be X,Y,Z, three numbers, such as 1000,250,250", typed));
    const Vec3<double> v{xyz[0], xyz[1], xyz[2]};
    if (const std::string why = why_no_direction(v); !why.empty())
        throw wrong(option, fmt::format("'{}' {}", typed, why));
    return v;
}

Ray<double> ray(std::string_view option, const std::string& typed) {
    std::vector<double> numbers;
    const std::vector<std::string> words = between_commas(typed);
    for (const std::string& word : words)
        if (const std::optional<double> value = read<double>(word); value && std::isfinite(*value))
            numbers.push_back(*value);
    if (words.size() != 6 || numbers.size() != 6)
        throw wrong(option,
                    fmt::format("'{}' must be OX,OY,OZ,DX,DY,DZ, six numbers: an origin and a direction", typed));
    const Ray<double> ray{{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}};
    if (!is_valid(ray)) throw wrong(option, fmt::format("'{}' has the direction 0,0,0; a ray runs somewhere", typed));
    return ray;
}

std::pair<int, int> size(std::string_view option, const std::string& typed) {
    const std::size_t cross = typed.find_first_of("xX");
    const auto side = [&](std::size_t from, std::size_t to) { return read<long long>(typed.substr(from, to)); };
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
        const std::optional<Turn<double>> one_turn = turn(one);
        if (!one_turn)
            throw wrong(option, fmt::format("'{}' must be an axis, x, y or z, and degrees, such as z:10 or z:10,y:-20",
                                            one.empty() ? typed : one));
        result.push_back(*one_turn);
    }
    return result;
}

TriangleRule triangle_rule(std::string_view option, const std::string& typed) {
    if (const auto tolerance = tolerance_text(typed))
        return Tolerance{
            factor(fmt::format("{} {}", option, name_of(TriangleRule(Tolerance{}))), std::string(*tolerance))};
    return chosen(option, typed, triangle_rules);
}

Setup with_typed(Setup setup, const Parameter& parameter, std::string_view option, const std::string& typed) {
    with_value(parameter, setup, [&](auto& value) {
        using Value = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, TriangleRule>) value = triangle_rule(option, typed);
        else if constexpr (is_choice<Value>) value = chosen(option, typed, choices<Value>);
        else if constexpr (std::is_same_v<Value, bool>) value = chosen(option, typed, switches);
        else if constexpr (std::is_same_v<Value, double>) value = factor(option, typed);
        else if constexpr (std::is_same_v<Value, Vec3<double>>) value = direction(option, typed);
        else if constexpr (std::is_same_v<Value, std::vector<Turn<double>>>) value = turns(option, typed);
        else {
            const auto& [least, most, format, is_logarithmic] = parameter.range;
            value = whole_number(option, typed, static_cast<int>(least), static_cast<int>(most));
        }
    });
    return setup;
}

Pixel pixel(std::string_view option, const std::string& typed, const Scene& scene) {
    const std::vector<std::string> words = between_commas(typed);
    if (words.size() != 2)
        throw wrong(option,
                    fmt::format("'{}' must be X,Y: x to the right and y down, (0,0) is the top-left pixel", typed));
    const auto coordinate = [&](const std::string& word, char name, int count) {
        const std::optional<int> value = read<int>(word);
        if (!value || *value < 0 || *value >= count)
            throw wrong(option, fmt::format("'{}': {} must be a whole number from 0 to {}; the picture is {}x{}", typed,
                                            name, count - 1, scene.width, scene.height));
        return *value;
    };
    return {coordinate(words[0], 'x', scene.width), coordinate(words[1], 'y', scene.height)};
}

const Measurement& measurement(std::string_view option, const std::string& typed) {
    if (const Measurement* found = find_measurement(typed)) return *found;
    std::vector<std::string_view> known;
    for (const Measurement& each : measurements()) known.push_back(each.name);
    throw wrong(option, fmt::format("'{}' is not known; {}", typed, suggestion(typed, known)));
}

namespace {

/// The parameter that a setting, "scalar:certified", begins with; null where it begins with none.
const Parameter* named_by(std::string_view setting) {
    const std::size_t colon = setting.find(':');
    if (colon == std::string_view::npos) return nullptr;
    const auto found = std::ranges::find(parameters(), setting.substr(0, colon), &Parameter::name);
    return found == parameters().end() ? nullptr : &*found;
}

/// Settings that stand between commas; what begins with no parameter belongs to the value before: "turn:z:10,y:5".
std::vector<std::string> settings_in(std::string_view option, const std::string& typed) {
    std::vector<std::string> settings;
    for (const std::string& word : between_commas(typed)) {
        if (named_by(word) || settings.empty()) settings.push_back(word);
        else settings.back() += ',' + word;
    }
    if (named_by(settings.front())) return settings;
    const std::string& first = settings.front();
    const std::size_t colon = first.find(':');
    if (colon == std::string::npos)
        throw wrong(option,
                    fmt::format("'{}' must be NAME:VALUE, an option and its value, such as scalar:certified", first));
    const std::string name = first.substr(0, colon);
    std::vector<std::string_view> known;
    for (const Parameter& parameter : parameters()) known.push_back(parameter.name);
    throw wrong(option, fmt::format("'{}' is no option; {}", name, suggestion(name, known)));
}

}  // namespace

Minus minus(std::string_view option, const std::string& typed) {
    Minus minus;
    std::vector<const Parameter*> named;
    for (const std::string& setting : settings_in(option, typed)) {
        const Parameter& parameter = *named_by(setting);
        if (std::ranges::count(named, &parameter) > 0)
            throw wrong(option, fmt::format("'{}' is there twice; name it once", parameter.name));
        named.push_back(&parameter);
        minus.setup = with_typed(std::move(minus.setup), parameter, fmt::format("{} {}", option, parameter.name),
                                 setting.substr(parameter.name.size() + 1));
    }
    for (const Parameter& parameter : parameters())
        if (std::ranges::count(named, &parameter) > 0) minus.told.push_back(&parameter);
    return minus;
}

std::vector<std::string> between_commas(const std::string& typed) {
    std::vector<std::string> words(1);
    for (const char c : typed)
        if (c == ',') words.emplace_back();
        else words.back() += c;
    return words;
}

}  // namespace glassbox
