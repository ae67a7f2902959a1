#include "cli/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

#include "cli/scene_path.hpp"
#include "render/view.hpp"
#include "scene/scene_file.hpp"
#include "scene/suggestion.hpp"

namespace glassbox {

namespace {

using Words = std::vector<std::string>;

template <class Value>
struct Choice {
    std::string_view name;
    Value value;
};

CLI::ValidationError wrong(std::string_view option, const std::string& message) {
    return CLI::ValidationError(std::string(option), message);
}

/// The value of the choice that was typed; an error that lists them, if it is none.
template <class Value, std::size_t count>
Value chosen(std::string_view option, const std::string& typed, const std::array<Choice<Value>, count>& choices) {
    std::vector<std::string_view> names;
    for (const auto& [name, value] : choices) {
        if (typed == name) return value;
        names.push_back(name);
    }
    throw wrong(option, fmt::format("'{}' is not known; {}", typed, suggestion(typed, names)));
}

Words split(const std::string& text, char separator) {
    Words words(1);
    for (const char c : text)
        if (c == separator) words.emplace_back();
        else words.back() += c;
    return words;
}

template <class Number>
std::optional<Number> number(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return {};
    return value;
}

/// A finite number, 0 or more.
double factor(std::string_view option, const std::string& typed) {
    const std::optional<double> value = number<double>(typed);
    if (!value || !std::isfinite(*value) || *value < 0)
        throw wrong(option, fmt::format("'{}' must be a number, 0 or more", typed));
    return *value;
}

std::pair<int, int> size(const std::string& typed) {
    const std::size_t cross = typed.find_first_of("xX");
    const auto side = [&](std::size_t from, std::size_t to) { return number<long long>(typed.substr(from, to)); };
    const auto width = cross == std::string::npos ? std::nullopt : side(0, cross);
    const auto height = cross == std::string::npos ? std::nullopt : side(cross + 1, std::string::npos);
    if (!width || !height)
        throw wrong("--size", fmt::format("'{}' must be WIDTHxHEIGHT in pixels, such as 800x600", typed));
    if (*width < 1 || *height < 1 || *width > max_side || *height > max_side || *width * *height > max_pixels)
        throw wrong("--size", fmt::format("{} must be from 1 to {} pixels a side, and at most {} in all", typed,
                                          max_side, max_pixels));
    return {static_cast<int>(*width), static_cast<int>(*height)};
}

Turn<double> turn(const std::string& typed) {
    const std::string_view text = typed;
    const bool has_axis = text.size() > 2 && text[0] >= 'x' && text[0] <= 'z' && text[1] == ':';
    std::string_view angle = has_axis ? text.substr(2) : std::string_view{};
    if (angle.size() > 1 && angle[0] == '+' && angle[1] != '-') angle.remove_prefix(1);
    const std::optional<double> degrees = number<double>(angle);
    if (!degrees || !std::isfinite(*degrees))
        throw wrong("--turn", fmt::format("'{}' must be an axis and degrees, such as z:10 or y:-20", typed));
    return {static_cast<Axis>(text[0] - 'x'), *degrees};
}

TriangleRule triangle_rule(const std::string& typed) {
    constexpr std::string_view with_number = "tolerance:";
    if (typed.rfind(with_number, 0) == 0)
        return Tolerance{factor("--triangle tolerance", typed.substr(with_number.size()))};
    return chosen<TriangleRule>(
        "--triangle", typed,
        std::array{Choice<TriangleRule>{"pluecker", Pluecker{}}, Choice<TriangleRule>{"tolerance", Tolerance{}},
                   Choice<TriangleRule>{"moeller-trumbore", MoellerTrumbore{}}});
}

constexpr std::array scalars{Choice<Scalar>{"float", Scalar::float_}, Choice<Scalar>{"double", Scalar::double_},
                             Choice<Scalar>{"long-double", Scalar::long_double}};
constexpr std::array models{Choice<ShadingModel>{"phong", ShadingModel::phong},
                            Choice<ShadingModel>{"blinn-phong", ShadingModel::blinn_phong},
                            Choice<ShadingModel>{"levental-2014", ShadingModel::levental_2014}};

/// An option that is read by a function of its own, from the text that was typed.
template <class Read>
CLI::Option* add(CLI::App& command, const std::string& name, const std::string& value, const std::string& help,
                 const Read& read) {
    return command.add_option_function<std::string>(name, read, help)->type_name(value);
}

}  // namespace

void add_scene_options(CLI::App& command, Request& request) {
    command.add_option("SCENE", request.scene, "a scene file, or the name of one that comes with Glassbox")->required();
    const auto whole = [](const char* option, long long least, long long most, int& target) {
        return [=, &target](const std::string& typed) {
            const std::optional<long long> value = number<long long>(typed);
            if (!value || *value < least || *value > most)
                throw wrong(option, fmt::format("'{}' must be a whole number from {} to {}", typed, least, most));
            target = static_cast<int>(*value);
        };
    };
    const auto factor_of = [](const char* option, std::optional<double>& target) {
        return [=, &target](const std::string& typed) { target = factor(option, typed); };
    };
    add(command, "--size", "WxH", "pixels of the picture (default: as the scene says)",
        [&](const std::string& typed) { request.size = size(typed); });
    add(command, "--stage", "1..5", "what is used: 1 rays, 2 spheres, 3 triangles, 4 shading, 5 turns (default 5)",
        whole("--stage", 1, 5, request.options.stage));
    add(command, "--turn", "AXIS:DEGREES,...", "turn the view about the world's axes, in this order: z:10,y:-20",
        [&](const std::string& typed) {
            for (const std::string& one : split(typed, ',')) request.options.turns.push_back(turn(one));
        });
    add(command, "--ambient", "K", "factor of the ambient term", factor_of("--ambient", request.ambient));
    add(command, "--diffuse", "K", "factor of the diffuse term", factor_of("--diffuse", request.diffuse));
    add(command, "--specular", "K", "factor of the specular term", factor_of("--specular", request.specular));
    add(command, "--exponent", "E", "exponent of the specular term", factor_of("--exponent", request.exponent));
    add(command, "--shading", "MODEL", "phong, blinn-phong or levental-2014",
        [&](const std::string& typed) { request.model = chosen("--shading", typed, models); });
    add(command, "--scalar", "S", "what the formulas run in: float, double (default) or long-double",
        [&](const std::string& typed) { request.options.scalar = chosen("--scalar", typed, scalars); });
    add(command, "--triangle", "RULE", "pluecker (default), tolerance[:10.0] or moeller-trumbore",
        [&](const std::string& typed) { request.options.triangle_rule = triangle_rule(typed); });
    add(command, "--sphere", "RULE", "stable (default) or textbook", [&](const std::string& typed) {
        request.options.sphere_rule = chosen<SphereRule>(
            "--sphere", typed,
            std::array{Choice<SphereRule>{"stable", Stable{}}, Choice<SphereRule>{"textbook", Textbook{}}});
    });
    add(command, "--threads", "N", "how many threads (default: as many as there are cores)",
        whole("--threads", 1, 1024, request.threads));
}

Scene load(const Request& request) {
    Scene scene = read_scene(scene_path(request.scene));
    if (request.size) scene = resized(std::move(scene), request.size->first, request.size->second);
    Shading<double>& shading = scene.shading;
    shading.model = request.model.value_or(shading.model);
    shading.k_a = request.ambient.value_or(shading.k_a);
    shading.k_d = request.diffuse.value_or(shading.k_d);
    shading.k_s = request.specular.value_or(shading.k_s);
    shading.exponent = request.exponent.value_or(shading.exponent);
    return scene;
}

}  // namespace glassbox
