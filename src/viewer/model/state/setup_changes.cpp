#include "viewer/model/state/setup_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "render/parameters.hpp"

namespace glassbox {

Setup with_figure(Setup setup, const Figure& figure) {
    setup.shading = {
        ShadingModel::levental_2014, figure.k_a, figure.k_d, figure.k_s, 15, {255, 102, 102}, {255, 255, 255}};
    setup.light_intensity = 1;
    setup.options.sphere_rule = Levental2014{};
    setup.options.stage = std::max(setup.options.stage, 4);
    return setup;
}

Setup turned(Setup setup, Axis axis, double degrees) {
    setup.options.turns.push_back({axis, degrees});
    return setup;
}

double last_turn(const Setup& setup, Axis axis) {
    const std::vector<Turn<double>>& turns = setup.options.turns;
    return turns.empty() || turns.back().axis != axis ? 0 : turns.back().degrees;
}

Setup with_last_turn(Setup setup, Axis axis, double degrees) {
    std::vector<Turn<double>>& turns = setup.options.turns;
    if (!turns.empty() && turns.back().axis == axis) turns.pop_back();
    return degrees == 0 ? setup : turned(std::move(setup), axis, degrees);
}

std::string turns_in_words(std::span<const Turn<double>> turns) {
    std::string text;
    for (std::size_t i = 0, next = 0; i < turns.size(); i = next) {
        while (next < turns.size() && turns[next] == turns[i]) ++next;
        const auto& [axis, degrees] = turns[i];
        text += fmt::format("{}{} {}{:g}°", i == 0 ? "" : ", ", "xyz"[static_cast<int>(axis)], degrees < 0 ? "−" : "",
                            std::abs(degrees));
        if (next - i > 1) text += fmt::format(" × {}", next - i);
    }
    return text.empty() ? "none" : text;
}

Setup followed(Setup setup, const Scene& before, const Scene& after) {
    const Setup was = setup_of(before), is = setup_of(after);
    for (const Parameter& parameter : parameters())
        if (is_same(parameter, setup, was)) setup = taken_over(std::move(setup), parameter, is);
    for (const Coefficient<double>& coefficient : coefficients<double>)
        if (const auto color = coefficient.color_member; color && setup.shading.*color == was.shading.*color)
            setup.shading.*color = is.shading.*color;
    return setup;
}

Pointing pointing(const Vec3<double>& v) {
    constexpr double degrees = 180 / std::numbers::pi;
    return {std::atan2(v.y, v.x) * degrees, std::atan2(v.z, std::hypot(v.x, v.y)) * degrees, length(v)};
}

Vec3<double> vector_of(const Pointing& pointing) {
    const auto [cos_a, sin_a] = cos_sin(pointing.azimuth);
    const auto [cos_e, sin_e] = cos_sin(pointing.elevation);
    return pointing.distance * Vec3<double>{cos_e * cos_a, cos_e * sin_a, sin_e};
}

}  // namespace glassbox
