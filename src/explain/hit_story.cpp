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
#include "explain/told_steps.hpp"
#include "render/lighting.hpp"
#include "render/search/exact_crossing.hpp"
#include "render/search/plain_search.hpp"
#include "render/tracer.hpp"
#include "scene/coefficients.hpp"

namespace glassbox {

namespace {

using namespace story;

/// Looks up a tape's numbers with their bounds and true values; without a replay, only their values.
class Lookup {
public:
    Lookup(const Tape& tape, Detail detail) {
        if (detail == Detail::whole) checked_ = replay(tape);
    }

    template <class Real>
    Number operator()(const Recorded<Real>& number) const {
        return number.tape() && !checked_.empty() ? checked_[number.step()] : unchecked(number.value());
    }
    template <class Real>
    Vector operator()(const Vec3<Recorded<Real>>& v) const {
        return {(*this)(v.x), (*this)(v.y), (*this)(v.z)};
    }

    const std::vector<Checked>& all() const { return checked_; }

private:
    std::vector<Checked> checked_;
};

/// The hit, recorded: t as the formula gives it, or, where exact arithmetic decided, as an input.
template <class Real, class Shape>
struct RecordedHit {
    Ray<Recorded<Real>> ray;
    Shape shape;
    Recorded<Real> t;
    bool t_by_exact = false;
    std::size_t test_steps = 0;  ///< how many steps of the tape are the test
};

template <class Real, class Shape, class Rule>
auto record_hit(Tape& tape, NamingProbe<Real>& heard, const TracedPixel& pixel, const Options& options,
                const Shape& shape, const Rule& rule) {
    const Ray<Recorded<Real>> ray = input<Real>(tape, pixel.ray);
    const auto recorded = input<Real>(tape, shape);
    const Crossing<Recorded<Real>> crossing = intersect(ray, recorded, Chosen{rule}, heard);
    const std::size_t test_steps = tape.steps().size();
    const bool by_exact = is_proven(options.scalar) && static_cast<double>(crossing.t.value()) != pixel.nearest->t;
    const Recorded<Real> t = by_exact ? Recorded<Real>::input(tape, pixel.nearest->t, "t") : crossing.t;
    name(t, "t");
    return RecordedHit<Real, std::remove_const_t<decltype(recorded)>>{ray, recorded, t, by_exact, test_steps};
}

/// The unit normal, as the renderer computes it.
template <class Real, class Shape>
Vec3<Recorded<Real>> normal_of(const RecordedHit<Real, Shape>& hit) {
    PlainSearch<Recorded<Real>, Stable, Pluecker> search{};
    if constexpr (std::is_same_v<Shape, Sphere<Recorded<Real>>>) search.surfaces.spheres = {hit.shape};
    else search.surfaces.triangles = {hit.shape};
    return search.normal_at(hit.ray, {0, hit.t});
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

/// Finds the step that lost the most bits beyond those that its operands had lost.
void find_worst(FirstHit& hit) {
    for (std::size_t i = 0; i < hit.steps.size(); ++i) {
        const double loss = bits_lost_by(hit.steps, hit.steps[i]);
        if (!(loss > hit.worst_loss)) continue;
        hit.worst = static_cast<StepNumber>(i);
        hit.worst_loss = loss;
    }
}

template <class Real, class Shape, class Rule>
ToldHit told_hit(const Scene& scene, const Options& options, const TracedPixel& pixel, Rgb own, Detail detail,
                 const Shape& shape, const Rule& rule) {
    Tape tape(Precision::of<Real>());
    NamingProbe<Real> heard;
    const auto at_hit = record_hit(tape, heard, pixel, options, shape, rule);
    const Vec3<Recorded<Real>> point = at(at_hit.ray, at_hit.t);
    name(point, "point");
    Vec3<Recorded<Real>> n = normal_of(at_hit);
    const Vec3<double> by_steps{static_cast<double>(n.x.value()), static_cast<double>(n.y.value()),
                                static_cast<double>(n.z.value())};
    const bool by_exact = is_proven(options.scalar) && is_finite(pixel.normal) && by_steps != pixel.normal;
    if (by_exact) n = input<Real>(tape, pixel.normal, "n");
    name(n, "n");
    std::optional<RecordedShade<Real>> shade;
    if (options.stage >= 4) shade = record_shade(tape, heard, scene, at_hit.ray, n, own);

    const Lookup look(tape, detail);
    FirstHit hit;
    hit.surface = pixel.nearest->surface;
    hit.t = look(at_hit.t);
    hit.t_by_exact = at_hit.t_by_exact;
    if (hit.t_by_exact && detail == Detail::whole)
        if (const std::optional<TrueT> truth = exact_crossing(pixel.ray, shape, rule))
            hit.t = checked(pixel.nearest->t, truth->exact());
    hit.point = look(point);
    hit.normal = look(n);
    if (shade) hit.shade = shade_story(scene, look, heard, *shade, own);
    hit.steps = told_steps(tape, look.all());
    hit.tested_before = at_hit.test_steps;
    find_worst(hit);
    return {std::move(hit), shade ? shade->color : own};
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
        return {look(color), bytes, told_steps(tape, look.all())};
    });
}

}  // namespace glassbox
