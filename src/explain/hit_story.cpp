#include "explain/hit_story.hpp"

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <ray_color.hpp>

#include "explain/inputs.hpp"
#include "explain/loss.hpp"
#include "explain/naming_probe.hpp"
#include "explain/scalar_of_steps.hpp"
#include "render/lighting.hpp"
#include "render/search/exact_crossing.hpp"
#include "render/search/plain_search.hpp"
#include "render/tracer.hpp"
#include "scene/coefficients.hpp"

namespace glassbox {

namespace {

using namespace story;

/// The unit normal, as the renderer computes it.
template <class Real, class Shape>
Vec3<Recorded<Real>> normal_of(const RecordedTest<Real, Shape>& test, const Recorded<Real>& t) {
    PlainSearch<Recorded<Real>, Stable, Pluecker> search{};
    if constexpr (std::is_same_v<Shape, Sphere<double>>) search.surfaces.spheres = {test.shape};
    else search.surfaces.triangles = {test.shape};
    return search.normal_at(test.ray, {0, t});
}

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

template <class Real>
Shade shade_story(const Scene& scene, const Lookup& look, const NamingProbe<Real>& heard, const RecordedShade<Real>& s,
                  Rgb own) {
    const Shading<double>& shading = scene.shading;
    const auto term = [&](double k, const Recorded<Real>& factor, const Vec3<double>& color,
                          const Vec3<Recorded<Real>>& product) {
        return Term{k, look(factor), color, look(product), truncated(product)};
    };
    return {.model = shading.model,
            .intensity = scene.light_intensity,
            .exponent = shading.exponent,
            .L = look(s.light.L),
            .l = look(s.light.l),
            .r = look(s.r),
            .n_l = look(heard.n_l),
            .n_r = look(heard.n_r),
            .h = look(heard.h),
            .highlight = look(heard.highlight),
            .ambient = term(shading.k_a, heard.ambient, shading.ambient_color, s.terms.ambient),
            .diffuse = term(shading.k_d, heard.diffuse, to_vec3<double>(own), s.terms.diffuse),
            .specular = term(shading.k_s, heard.specular, shading.specular_color, s.terms.specular),
            .sum = look(s.sum)};
}

/// Finds the step that lost the most bits of its own.
void find_worst(FirstHit& hit) {
    for (const StepNumber worst : worst_losses(hit.steps, 1)) {
        hit.worst = worst;
        hit.worst_loss = hit.steps[worst].checked.own_loss;
    }
}

template <class Real, class Shape, class Rule>
ToldHit told_hit(const Scene& scene, const Options& options, const TracedPixel& pixel, Rgb own, Detail detail,
                 const Shape& shape, const Rule& rule) {
    RecordedTest<Real, Shape> test(pixel.ray, shape, rule);
    Tape& tape = test.tape;
    // Where exact arithmetic decided, t and n are inputs.
    const bool t_by_exact =
        is_proven(options.scalar) && static_cast<double>(test.crossing.t.value()) != pixel.nearest->t;
    const Recorded<Real> t = t_by_exact ? Recorded<Real>::input(tape, pixel.nearest->t, "t") : test.crossing.t;
    name(t, "t");
    const Vec3<Recorded<Real>> point = at(test.ray, t);
    name(point, "point");
    Vec3<Recorded<Real>> n = normal_of(test, t);
    const Vec3<double> by_steps{static_cast<double>(n.x.value()), static_cast<double>(n.y.value()),
                                static_cast<double>(n.z.value())};
    const bool n_by_exact = is_proven(options.scalar) && is_finite(pixel.normal) && by_steps != pixel.normal;
    if (n_by_exact) n = input<Real>(tape, pixel.normal, "n");
    name(n, "n");
    std::optional<RecordedShade<Real>> shade;
    if (options.stage >= 4) shade = record_shade(tape, test.heard, scene, test.ray, n, own);
    const std::size_t step_count = tape.steps().size();
    const auto weights = test.weights();

    const Lookup look(tape, detail);
    FirstHit hit;
    hit.surface = pixel.nearest->surface;
    hit.t = look(t);
    hit.t_by_exact = t_by_exact;
    if (hit.t_by_exact && detail != Detail::recorded)
        if (const std::optional<TrueT> truth = exact_crossing(pixel.ray, shape, rule))
            hit.t = checked(pixel.nearest->t, truth->exact());
    hit.point = look(point);
    hit.normal = look(n);
    if (shade) hit.shade = shade_story(scene, look, test.heard, *shade, own);
    hit.steps = look.steps(step_count);
    hit.calls = tape.calls();
    hit.tested_before = test.step_count;
    find_worst(hit);
    return {std::move(hit), shade ? shade->color : own,
            detail != Detail::recorded ? std::optional(looked_up(test, weights, look)) : std::nullopt};
}

}  // namespace

ToldHit hit_story(const Scene& scene, const engine::Engine& surfaces, const Options& options, const TracedPixel& pixel,
                  Rgb own_color, Detail detail) {
    return surfaces.with_surface(pixel.nearest->surface, [&]<class Shape>(const Shape& shape) {
        return with_scalar_of_steps(options.scalar, [&]<class Real>(std::type_identity<Real>) {
            const auto tell = [&](const auto& rule) {
                return told_hit<Real>(scene, options, pixel, own_color, detail, shape, rule);
            };
            if constexpr (std::is_same_v<Shape, Sphere<double>>) return tell(options.sphere_rule);
            else return tell(options.triangle_rule);
        });
    });
}

ToldRay ray_story(const TracedPixel& pixel, Scalar scalar, int column, int row, Detail detail) {
    return with_scalar_of_steps(scalar, [&]<class Real>(std::type_identity<Real>) -> ToldRay {
        Tape tape(Precision::of<Real>());
        const Vec3<Recorded<Real>> color = ray_color(input<Real>(tape, pixel.ray), column, row);
        name(color, "colour");
        const Rgb bytes = rounded(color);
        const Lookup look(tape, detail);
        return {look(color), bytes, look.steps(tape.steps().size()), tape.calls()};
    });
}

}  // namespace glassbox
