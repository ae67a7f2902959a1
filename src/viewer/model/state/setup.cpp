#include "viewer/model/state/setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glassbox {

Setup setup_of(const Scene& scene) { return {{}, scene.shading, scene.light_vector, scene.light_intensity}; }

Scene applied(Scene scene, const Setup& setup) {
    scene.shading = setup.shading;
    scene.light_vector = setup.light_vector;
    scene.light_intensity = setup.light_intensity;
    return scene;
}

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
    const auto follow = [](auto& value, const auto& was, const auto& is) {
        if (value == was) value = is;
    };
    Shading<double>& shading = setup.shading;
    follow(shading.model, before.shading.model, after.shading.model);
    follow(shading.k_a, before.shading.k_a, after.shading.k_a);
    follow(shading.k_d, before.shading.k_d, after.shading.k_d);
    follow(shading.k_s, before.shading.k_s, after.shading.k_s);
    follow(shading.exponent, before.shading.exponent, after.shading.exponent);
    follow(shading.ambient_color, before.shading.ambient_color, after.shading.ambient_color);
    follow(shading.specular_color, before.shading.specular_color, after.shading.specular_color);
    follow(setup.light_vector, before.light_vector, after.light_vector);
    follow(setup.light_intensity, before.light_intensity, after.light_intensity);
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
