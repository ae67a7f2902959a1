#pragma once
#include <cstddef>
#include <cstdint>

#include <vec3.hpp>

#include "learn/picture/sheet.hpp"
#include "render/options.hpp"
#include "scene/coefficients.hpp"
#include "scene/scene.hpp"

// What a learner's program reads from its sheet.
namespace glassbox::learn::mine {

inline Vec3<double> vector(const double (&from)[3]) {
    Vec3<double> v;
    v.x = from[0], v.y = from[1], v.z = from[2];
    return v;
}

inline Rgb color(const std::uint8_t (&from)[3]) { return {from[0], from[1], from[2]}; }

/// The scene as far as it is traced.
inline Scene scene_of(Sheet& sheet) {
    const SheetLists lists = lists_of(sheet);
    Scene scene;
    scene.width = sheet.width;
    scene.height = sheet.height;
    scene.background = color(sheet.background);
    if (sheet.pinhole)
        scene.view =
            PinholeView{vector(sheet.view[0]), vector(sheet.view[1]), vector(sheet.view[2]), sheet.field_of_view};
    else
        scene.view =
            ParallelView{vector(sheet.view[0]), vector(sheet.view[1]), vector(sheet.view[2]), vector(sheet.view[3])};
    scene.pivot = vector(sheet.pivot);
    scene.light_vector = vector(sheet.light);
    scene.light_intensity = sheet.intensity;
    scene.shading.model = static_cast<ShadingModel>(sheet.shading_model);
    for (std::size_t i = 0; i < coefficients<double>.size(); ++i)
        scene.shading.*coefficients<double>[i].member = sheet.coefficients[i];
    for (std::size_t i = 0; i < coefficients<double>.size(); ++i)
        if (const auto color = coefficients<double>[i].color_member) scene.shading.*color = vector(sheet.colors[i]);
    for (std::int64_t i = 0; i < sheet.spheres; ++i) {
        const auto& [center, radius, own] = lists.spheres[i];
        scene.spheres.push_back({vector(center), radius, color(own)});
    }
    for (std::int64_t i = 0; i < sheet.triangles; ++i) {
        const auto& [vertices, own] = lists.triangles[i];
        scene.triangles.push_back({{vector(vertices[0]), vector(vertices[1]), vector(vertices[2])}, color(own)});
    }
    return scene;
}

/// The options, but for the rules, which are chosen as the program is compiled.
inline Options options_of(Sheet& sheet) {
    Options options;
    options.stage = sheet.stage;
    options.accumulated = sheet.accumulated != 0;
    for (std::int64_t i = 0; i < sheet.turns; ++i) {
        const auto& [axis, degrees] = lists_of(sheet).turns[i];
        options.turns.push_back({static_cast<Axis>(axis), degrees});
    }
    return options;
}

/// The rule, with its tolerance if it has one.
template <class TriangleTest>
TriangleTest triangle_rule(const Sheet& sheet) {
    TriangleTest test{};
    if constexpr (requires { test.tolerance; }) test.tolerance = sheet.tolerance;
    return test;
}

}  // namespace glassbox::learn::mine
