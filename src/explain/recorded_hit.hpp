#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include <ray_color.hpp>

#include "explain/inputs.hpp"
#include "explain/naming_probe.hpp"
#include "explain/recorded_test.hpp"
#include "render/lighting.hpp"
#include "render/search/plain_search.hpp"
#include "scene/coefficients.hpp"

// What is computed for a pixel besides the tests of surfaces, each operation recorded. It includes no more than it
// needs: a learner's program is compiled with it.
namespace glassbox {

/// The unit normal, as the renderer computes it.
template <class Real, class Shape>
Vec3<Recorded<Real>> recorded_normal(const RecordedTest<Real, Shape>& test, const Recorded<Real>& t) {
    PlainSearch<Recorded<Real>, Stable, Pluecker> search{};
    if constexpr (std::is_same_v<Shape, Sphere<double>>) search.surfaces.spheres = {test.shape};
    else search.surfaces.triangles = {test.shape};
    return search.normal_at(test.ray, {0, t});
}

/// The shading's parameters as inputs.
template <class Real>
Shading<Recorded<Real>> input(Tape& tape, const Shading<double>& s) {
    return converted<Recorded<Real>>(
        s,
        [&](double number, std::string_view symbol) {
            return Recorded<Real>::input(tape, number, std::string(symbol));
        },
        [&](const Vec3<double>& color, std::string_view name) {
            return glassbox::input<Real>(tape, color, std::string(name));
        });
}

/// The light where the ray meets a surface.
template <class Real>
struct RecordedShade {
    Vec3<Recorded<Real>> r, sum;
    Light<Recorded<Real>> light;
    Terms<Recorded<Real>> terms;
    Rgb color;
};

template <class Real>
RecordedShade<Real> record_shade(Tape& tape, NamingProbe<Real>& heard, const Scene& scene,
                                 const Ray<Recorded<Real>>& ray, const Vec3<Recorded<Real>>& n, Rgb own_color) {
    const Lighting lit = lighting<Real>(scene);
    const Light<Recorded<Real>> light =
        directional_light(glassbox::input<Real>(tape, lit.L, "L"), Recorded<Real>::input(tape, lit.I, "I"));
    name(light.l, "l");
    const Vec3<Recorded<Real>> r = unit(-ray.D);
    name(r, "r");
    const Vec3<Recorded<Real>> own = glassbox::input<Real>(tape, to_vec3<double>(own_color), "color");
    const Shading<Recorded<Real>> shading = input<Real>(tape, lit.shading);
    const Terms<Recorded<Real>> terms = shade_by_model(n, r, own, light, shading, heard);
    name(terms.ambient, "ambient");
    name(terms.diffuse, "diffuse");
    name(terms.specular, "specular");
    const Vec3<Recorded<Real>> sum = terms.ambient + terms.diffuse + terms.specular;
    name(sum, "sum");
    return {r, sum, light, terms, to_rgb(terms, scene.shading.model)};
}

/// What exact arithmetic decided about a hit. Where the steps come to something else, these are inputs.
struct DecidedHit {
    std::optional<double> t;
    std::optional<Vec3<double>> normal;
};

/// What follows the test of the surface that is seen, on the test's tape.
template <class Real>
struct RecordedHit {
    Recorded<Real> t;
    bool t_by_exact = false;  ///< t is an input
    Vec3<Recorded<Real>> point, normal;
    std::optional<RecordedShade<Real>> shade;  ///< from stage 4
};

template <class Real, class Shape>
RecordedHit<Real> record_hit(RecordedTest<Real, Shape>& test, const Scene& scene, int stage, Rgb own_color,
                             const DecidedHit& decided = {}) {
    Tape& tape = test.tape;
    RecordedHit<Real> hit;
    hit.t_by_exact = decided.t && static_cast<double>(test.crossing.t.value()) != *decided.t;
    hit.t = hit.t_by_exact ? Recorded<Real>::input(tape, *decided.t, "t") : test.crossing.t;
    name(hit.t, "t");
    hit.point = at(test.ray, hit.t);
    name(hit.point, "point");
    Vec3<Recorded<Real>> n = recorded_normal(test, hit.t);
    const Vec3<double> by_steps{static_cast<double>(n.x.value()), static_cast<double>(n.y.value()),
                                static_cast<double>(n.z.value())};
    if (decided.normal && by_steps != *decided.normal) n = input<Real>(tape, *decided.normal, "n");
    name(n, "n");
    hit.normal = n;
    if (stage >= 4) hit.shade = record_shade(tape, test.heard, scene, test.ray, n, own_color);
    return hit;
}

/// Stage 1: the ray's direction as a colour.
template <class Real>
struct RecordedRayColor {
    Vec3<Recorded<Real>> color;
    Rgb bytes;
};

template <class Real>
RecordedRayColor<Real> record_ray_color(Tape& tape, const Ray<double>& ray, int column, int row) {
    const Vec3<Recorded<Real>> color = ray_color(input<Real>(tape, ray), column, row);
    name(color, "colour");
    return {color, rounded(color)};
}

}  // namespace glassbox
