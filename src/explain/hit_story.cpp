#include "explain/hit_story.hpp"

#include <type_traits>
#include <utility>

#include "explain/loss.hpp"
#include "explain/recorded_hit.hpp"
#include "explain/scalar_of_steps.hpp"
#include "render/search/exact_crossing.hpp"
#include "render/tracer.hpp"

namespace glassbox {

namespace {

using namespace story;

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
    const Tape& tape = test.tape;
    DecidedHit decided;
    if (is_proven(options.scalar)) {
        decided.t = pixel.nearest->t;
        if (is_finite(pixel.normal)) decided.normal = pixel.normal;
    }
    const auto [t, t_by_exact, point, n, shade] = record_hit(test, scene, options.stage, own, decided);
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
        const auto& [color, bytes] = record_ray_color<Real>(tape, pixel.ray, column, row);
        const Lookup look(tape, detail);
        return {look(color), bytes, look.steps(tape.steps().size()), tape.calls()};
    });
}

}  // namespace glassbox
