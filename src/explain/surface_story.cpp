#include "explain/surface_story.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "explain/scalar_of_steps.hpp"
#include "render/search/exact_crossing.hpp"

namespace glassbox {

namespace {

using namespace story;

/// The probe that measures by how much a ray misses a surface, as a fraction: 0 if its line does not miss.
struct Nearness {
    double miss = 0;

    template <class What, class... Values>
    void operator()(What, const Values&...) {}

    /// How far Δ is below 0, as a part of its distance from D²r², its value for a line through the centre.
    void operator()(told::Discriminant, double discriminant) {
        if (discriminant < 0) miss = discriminant / (discriminant - through_centre);
    }
    /// The smaller of the positive and the negative part of the sides, relative to their total.
    void operator()(told::Sides, double a, double b, double c) {
        double positive = 0, negative = 0;
        for (const double side : {a, b, c}) (side > 0 ? positive : negative) += std::abs(side);
        const double both = positive + negative;
        miss = both > 0 ? std::min(positive, negative) / both : 1;
    }

    double through_centre = 0;
};

double miss(const Ray<double>& ray, const Sphere<double>& sphere) {
    Nearness nearness;
    nearness.through_centre = dot(ray.D, ray.D) * sphere.r * sphere.r;
    intersect(ray, sphere, Stable{}, nearness);
    return nearness.miss;
}

double miss(const Ray<double>& ray, const Triangle<double>& triangle) {
    Nearness nearness;
    intersect(ray, triangle, Pluecker{}, nearness);
    return nearness.miss;
}

/// Where the ray meets that surface; null if it does not.
const Hit<long double>* met(const TracedPixel& pixel, std::size_t number) {
    const auto hit = std::ranges::lower_bound(pixel.met, number, {}, &Hit<long double>::surface);
    return hit != pixel.met.end() && hit->surface == number ? &*hit : nullptr;
}

template <class Real, class Shape, class Rule>
ToldTest told_test(const Ray<double>& ray, const Shape& shape, const Rule& rule) {
    RecordedTest<Real, Shape> test(ray, shape, rule);
    const auto weights = test.weights();
    return looked_up(test, weights, Lookup(test.tape));
}

/// All rules that a surface's story shows; `by_rule` is the test by the chosen one.
template <class Real>
SphereTest all_tests(const Ray<double>& ray, const Sphere<double>& sphere, const Options& options,
                     const ToldTest& by_rule) {
    const auto roots_by = [&](const SphereRule& rule) {
        const auto roots = [](const ToldTest& test) { return RootPair{*test.discriminant, test.t0, test.t1}; };
        return rule == options.sphere_rule ? roots(by_rule) : roots(told_test<Real>(ray, sphere, rule));
    };
    return {sphere.C, sphere.r, roots_by(Textbook{}), roots_by(Stable{})};
}

template <class Real>
TriangleTest all_tests(const Ray<double>& ray, const Triangle<double>& triangle, const Options& options,
                       const ToldTest& by_rule) {
    const auto* chosen = std::get_if<Tolerance>(&options.triangle_rule);
    const Tolerance rule = chosen ? *chosen : Tolerance{};
    const ToldTest other = chosen ? ToldTest{} : told_test<Real>(ray, triangle, TriangleRule(rule));
    const ToldTest& test = chosen ? by_rule : other;
    return {.vertices = {triangle.A, triangle.B, triangle.C},
            .a = *test.a,
            .b = *test.b,
            .c = *test.c,
            .sum = *test.sum,
            .deficit = *test.deficit,
            .tolerance = rule.tolerance,
            .accepted = test.met,
            .weights = test.weights};
}

/// The deciding sign: the true one if the renderer proves it, else that of the computed number.
int deciding_sign(const Number& number, const Options& options) {
    if (is_proven(options.scalar) && number.known != Known::not_at_all && !may_be_zero(number)) return number.sign;
    return number.recorded > 0 ? 1 : number.recorded < 0 ? -1 : 0;
}

/// Whether a deciding number overflowed; proven answers do not depend on it.
bool is_lost(const Number& number, const Options& options) {
    return !is_proven(options.scalar) && !std::isfinite(number.recorded);
}

/// Why a sphere was missed.
Fate why_missed(const SphereTest& test, const std::optional<Number>&, const Options& options) {
    const RootPair& roots = std::holds_alternative<Stable>(options.sphere_rule) ? test.stable : test.textbook;
    const bool history = std::holds_alternative<Levental2014>(options.sphere_rule);
    if (is_lost(roots.discriminant, options)) return Fate::overflow;
    const int sign = deciding_sign(roots.discriminant, options);
    if (sign < 0) return Fate::apart;
    if (sign == 0 && history) return Fate::touched;
    if (!roots.t1) return Fate::refused;
    if (deciding_sign(*roots.t1, options) <= 0) return Fate::behind;
    return history && deciding_sign(*roots.t0, options) <= 0 ? Fate::from_inside : Fate::refused;
}

/// Why a triangle was missed; `t` is where the line meets its plane, if it was computed.
Fate why_missed(const TriangleTest& test, const std::optional<Number>& t, const Options& options) {
    if (is_lost(test.a, options) || is_lost(test.b, options) || is_lost(test.c, options)) return Fate::overflow;
    if (std::holds_alternative<Tolerance>(options.triangle_rule)) {
        if (!(test.deficit.value < test.tolerance)) return Fate::beyond_tolerance;
    } else {
        const auto [least, most] = std::minmax(
            {deciding_sign(test.a, options), deciding_sign(test.b, options), deciding_sign(test.c, options)});
        if (least < 0 && most > 0) return Fate::outside;
        if (least == 0 && most == 0) return Fate::edge_on;
    }
    if (deciding_sign(test.sum, options) == 0) return Fate::edge_on;
    if (t && is_lost(*t, options)) return Fate::overflow;
    return t && deciding_sign(*t, options) <= 0 ? Fate::behind : Fate::refused;
}

template <class Real, class Shape, class Rule>
Surface tell_of(const Ray<double>& ray, const Shape& shape, const Rule& rule, const Options& options,
                const TracedPixel& pixel, std::size_t number, std::optional<ToldTest> known) {
    ToldTest by_rule = known ? *std::move(known) : told_test<Real>(ray, shape, rule);
    Surface result;
    result.number = number;
    const auto test = all_tests<Real>(ray, shape, options, by_rule);
    result.test = test;
    result.t = by_rule.t;
    result.steps = std::move(by_rule.steps);
    result.calls = std::move(by_rule.calls);
    const Hit<long double>* const hit = met(pixel, number);
    if (!hit) {
        result.fate = why_missed(result.test, result.t, options);
        if (result.fate != Fate::behind && result.fate != Fate::from_inside) result.t.reset();
        return result;
    }
    result.fate = pixel.nearest && pixel.nearest->surface == number ? Fate::nearest : Fate::farther;
    const auto t = static_cast<double>(hit->t);
    if (!result.t || result.t->value != t) {
        const std::optional<TrueT> truth = exact_crossing(ray, shape, rule);
        result.t = truth ? checked(t, truth->exact()) : unchecked(t);
        if (!truth) result.t->known = Known::not_at_all;
    }
    return result;
}

/// Calls `use(shape, rule)` with a surface and the rule that tests it.
template <class Use>
auto with_rule(const engine::Engine& surfaces, std::size_t number, const Options& options, const Use& use) {
    return surfaces.with_surface(number, [&]<class Shape>(const Shape& shape) {
        if constexpr (std::is_same_v<Shape, Sphere<double>>) return use(shape, options.sphere_rule);
        else return use(shape, options.triangle_rule);
    });
}

/// Whether two surfaces are met at the same t: truly, if the renderer proves it, else as far as its scalar tells.
bool are_as_near(const engine::Engine& surfaces, const Options& options, const TracedPixel& pixel, std::size_t one,
                 std::size_t other) {
    if (!is_proven(options.scalar)) return met(pixel, one)->t == met(pixel, other)->t;
    const auto truth = [&](std::size_t number) {
        return with_rule(surfaces, number, options,
                         [&](const auto& shape, const auto& rule) { return exact_crossing(pixel.ray, shape, rule); });
    };
    const std::optional<TrueT> t = truth(one), other_t = truth(other);
    return t && other_t && compare(*t, *other_t) == 0;
}

}  // namespace

story::Fate why_missed(const std::variant<story::SphereTest, story::TriangleTest>& test,
                       const std::optional<story::Number>& t, const Options& options) {
    if (const auto* sphere = std::get_if<SphereTest>(&test)) return why_missed(*sphere, t, options);
    return why_missed(std::get<TriangleTest>(test), t, options);
}

std::vector<std::size_t> worth_telling(const engine::Engine& surfaces, const TracedPixel& pixel,
                                       std::span<const std::size_t> besides, std::size_t most) {
    std::vector<std::size_t> chosen;
    for (const auto& hit : pixel.met) chosen.push_back(hit.surface);
    const auto is_chosen = [&](std::size_t number) {
        return std::find(chosen.begin(), chosen.end(), number) != chosen.end();
    };
    for (const std::size_t number : besides)
        if (!is_chosen(number)) chosen.push_back(number);
    if (chosen.size() < most) {
        // The nearest misses so far, the farthest of them on top.
        std::priority_queue<std::pair<double, std::size_t>> missed;
        surfaces.for_each_surface([&](std::size_t number, const auto& surface) {
            if (met(pixel, number) || std::find(besides.begin(), besides.end(), number) != besides.end()) return;
            const std::pair by{surfaces.size() <= most ? 0 : miss(pixel.ray, surface), number};
            if (missed.size() == most - chosen.size()) {
                if (missed.top() < by) return;
                missed.pop();
            }
            missed.push(by);
        });
        for (; !missed.empty(); missed.pop()) chosen.push_back(missed.top().second);
    }
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

Surface surface_story(const engine::Engine& surfaces, const Options& options, const TracedPixel& pixel,
                      std::size_t number, std::optional<ToldTest> known) {
    Surface result = with_rule(surfaces, number, options, [&](const auto& shape, const auto& rule) {
        return with_scalar_of_steps(options.scalar, [&]<class Real>(std::type_identity<Real>) {
            return tell_of<Real>(pixel.ray, shape, rule, options, pixel, number, std::move(known));
        });
    });
    if (result.fate == Fate::farther && are_as_near(surfaces, options, pixel, number, pixel.nearest->surface))
        result.fate = Fate::as_near;
    const auto& exact = pixel.needed_exact;
    result.needed_exact = std::find(exact.begin(), exact.end(), number) != exact.end();
    return result;
}

}  // namespace glassbox
