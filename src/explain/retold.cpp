#include "explain/retold.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "explain/loss.hpp"
#include "explain/story_of_pixel.hpp"
#include "explain/surface_kind.hpp"
#include "explain/surface_story.hpp"
#include "explain/told_test.hpp"
#include "render/measure/reference_search.hpp"
#include "render/search/surfaces.hpp"

namespace glassbox {

namespace {

using namespace story;

/// A tape that was replayed, and what is called how on it.
class Told {
public:
    explicit Told(const Tape& tape) : tape_(tape), look_(tape), names_(tape.names()) {}

    std::vector<StoryStep> steps() const { return look_.steps(tape_.steps().size()); }
    Number at(StepNumber step) const { return look_.at(step); }

    /// The number that was told last by that name.
    std::optional<Number> called(std::string_view name) const {
        for (std::size_t i = names_.size(); i-- > 0;)
            if (names_[i] == name) return look_.at(static_cast<StepNumber>(i));
        return {};
    }
    Vector vector(const std::string& name) const {
        const auto number = [&](const char* axis) { return called(name + axis).value_or(Number{}); };
        return {number(".x"), number(".y"), number(".z")};
    }

private:
    const Tape& tape_;
    Lookup look_;
    std::vector<std::string> names_;
};

std::optional<SphereTest> told_test(const Told& told, const Sphere<double>& sphere, const Options&) {
    const std::optional<Number> discriminant = told.called("Δ");
    if (!discriminant) return {};
    const RootPair roots{*discriminant, told.called("t₀"), told.called("t₁")};
    return SphereTest{sphere.C, sphere.r, roots, roots};
}

std::optional<TriangleTest> told_test(const Told& told, const Triangle<double>& triangle, const Options& options) {
    const std::optional<Number> a = told.called("a"), b = told.called("b"), c = told.called("c");
    if (!a || !b || !c) return {};
    TriangleTest test{.vertices = {triangle.A, triangle.B, triangle.C},
                      .a = *a,
                      .b = *b,
                      .c = *c,
                      .sum = told.called("a+b+c").value_or(unchecked(a->recorded + b->recorded + c->recorded)),
                      .deficit = told.called("| |a+b+c| − (|a|+|b|+|c|) |").value_or(Number{}),
                      .weights = {}};
    if (const auto* const rule = std::get_if<Tolerance>(&options.triangle_rule)) test.tolerance = rule->tolerance;
    return test;
}

template <class Shape>
void tell_test(Surface& surface, const Told& told, const Shape& shape, const Options& options) {
    const auto test = told_test(told, shape, options);
    if constexpr (std::is_same_v<Shape, Sphere<double>>)
        surface.test = test.value_or(SphereTest{shape.C, shape.r, {}, {}});
    else surface.test = test.value_or(TriangleTest{{shape.A, shape.B, shape.C}, {}, {}, {}, {}, {}, 0, false, {}});
    if (is_met(surface.fate)) return;
    if (test) surface.fate = why_missed(surface.test, surface.t, options);
    // A formula that is wrong may choose a t behind the start though the other root lies ahead.
    if (surface.fate == Fate::refused && surface.t && surface.t->value <= 0) surface.fate = Fate::behind;
    if (surface.fate != Fate::behind && surface.fate != Fate::from_inside) surface.t.reset();
}

/// How a surface that was met lies to the one that is seen.
Fate fate_of(const RecordedSurface& test, const std::optional<RecordedSurface>& hit) {
    if (!test.met) return Fate::refused;
    if (hit && hit->number == test.number) return Fate::nearest;
    return hit && hit->t == test.t ? Fate::as_near : Fate::farther;
}

Surface told_surface(const RecordedPixel& recorded, const RecordedSurface& test, const engine::Engine& surfaces,
                     const Options& options) {
    const Told told(test.tape);
    Surface surface;
    surface.number = test.number;
    surface.is_finished = test.is_finished;
    surface.fate = fate_of(test, recorded.hit);
    surface.steps = told.steps();
    surface.calls = test.tape.calls();
    if (test.t_step) {
        surface.t = told.at(*test.t_step);
        std::string& its_name = surface.steps[*test.t_step].name;
        if (its_name.empty()) its_name = "t";
    } else if (test.met) surface.t = unchecked(test.t);
    surfaces.with_surface(test.number, [&](const auto& shape) { tell_test(surface, told, shape, options); });
    return surface;
}

Shade told_shade(const Told& told, const Scene& scene, Rgb own) {
    const Shading<double>& shading = scene.shading;
    const auto number = [&](std::string_view name) { return told.called(name).value_or(Number{}); };
    const auto term = [&](double k, std::string_view factor, const Vec3<double>& color, const std::string& name) {
        const Vector product = told.vector(name);
        return Term{k, number(factor), color, product,
                    truncated(Vec3<double>{product.x.value, product.y.value, product.z.value})};
    };
    const bool blinn = told.called("n·h").has_value();
    return {.model = shading.model,
            .intensity = scene.light_intensity,
            .exponent = shading.exponent,
            .L = told.vector("L"),
            .l = told.vector("l"),
            .r = told.vector("r"),
            .n_l = number("n·l"),
            .n_r = number("n·r"),
            .h = told.vector(blinn ? "h" : "m"),
            .highlight = number(blinn ? "n·h" : "r·m"),
            .ambient = term(shading.k_a, "k_a", shading.ambient_color, "ambient"),
            .diffuse = term(shading.k_d, "diffuse", to_vec3<double>(own), "diffuse"),
            .specular = term(shading.k_s, "specular", shading.specular_color, "specular"),
            .sum = told.vector("sum")};
}

FirstHit told_hit(const RecordedSurface& recorded, const Scene& scene, const Options& options, Rgb own) {
    const Told told(recorded.tape);
    FirstHit hit;
    hit.surface = recorded.number;
    hit.t = recorded.t_step ? told.at(*recorded.t_step) : unchecked(recorded.t);
    hit.point = told.vector("point");
    hit.normal = told.vector("n");
    if (options.stage >= 4) hit.shade = told_shade(told, scene, own);
    hit.steps = told.steps();
    hit.calls = recorded.tape.calls();
    hit.tested_before = recorded.test_steps;
    for (const StepNumber worst : worst_losses(hit.steps, 1)) {
        hit.worst = worst;
        hit.worst_loss = hit.steps[worst].checked.own_loss;
    }
    return hit;
}

EarlyEnd early_end(const RecordedPixel& recorded) {
    EarlyEnd end{recorded.ended, recorded.hit.has_value(), {}};
    const RecordedSurface* const last = recorded.hit              ? &*recorded.hit
                                        : !recorded.tests.empty() ? &recorded.tests.back()
                                                                  : nullptr;
    if (last && !last->is_finished) end.in = last->tape.calls()[last->open_call];
    return end;
}

}  // namespace

Story retold(const Scene& scene, const std::shared_ptr<const engine::Engine>& surfaces, Options options, int x, int y,
             const RecordedPixel& recorded) {
    options.scalar = Scalar::double_;
    const std::vector<Rgb> colors = surface_colors(scene);
    Story story = story_of_pixel(scene, options, recorded.ray, x, y);
    story.in_all = story.tested = surfaces->size();
    story.met = recorded.met;
    story.traced = recorded.color.value_or(scene.background);
    story.border = is_on_border(scene, x, y);
    story.color = story.border ? *scene.border : story.traced;
    story.own = recorded.sources;
    if (!recorded.ended.empty()) story.ended = early_end(recorded);
    if (recorded.ray_color) {
        const Told told(*recorded.ray_color);
        story.ray_color = told.vector("colour");
        story.ray_steps = told.steps();
        story.ray_calls = recorded.ray_color->calls();
    }
    const TrueHits truth =
        options.stage > 1 && is_valid(recorded.ray) ? ReferenceSearch(surfaces).hits(recorded.ray) : TrueHits{};
    for (const RecordedSurface& test : recorded.tests) {
        if (test.number >= surfaces->size()) continue;
        Surface surface = told_surface(recorded, test, *surfaces, options);
        surface.truly_met = truth.has(test.number);
        surface.truly_nearest = truth.nearest == test.number;
        surface.kind = kind_of(scene, test.number);
        surface.color = colors[test.number];
        story.surfaces.push_back(std::move(surface));
    }
    story.not_listed = story.in_all - story.surfaces.size();
    if (recorded.hit && recorded.hit->number < surfaces->size())
        story.hit = told_hit(*recorded.hit, scene, options, colors[recorded.hit->number]);
    return story;
}

}  // namespace glassbox
