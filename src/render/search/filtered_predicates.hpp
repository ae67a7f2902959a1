#pragma once
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include <filter.hpp>
#include <probe.hpp>

#include "numerics/bounded_pair.hpp"
#include "render/rules.hpp"
#include "render/search/exact_crossing.hpp"
#include "render/search/ordinary_scale.hpp"
#include "render/search/probe_flags.hpp"
#include "render/search/surface_normal.hpp"
#include "render/search/surfaces.hpp"
#include "render/search/without_rounding.hpp"

namespace glassbox {

namespace told {
struct Undecided {};  ///< (surface): error bounds could not tell whether the ray meets it; exact arithmetic did
}  // namespace told

/// A hit that is proven.
struct ProvenHit {
    std::size_t surface;
    Bounded t;      ///< its bound is infinite until somebody needs one
    double told_t;  ///< t as it was found first: the same whatever else the ray meets
    /// Between these the true t lies; both are nearly t, for a triangle that is hit for sure.
    double nearest = 0, farthest = std::numeric_limits<double>::infinity();
    Support support =
        {};  ///< of a triangle, the corners that its point lies between, if it is known to lie between fewer
};

/// A sphere moved so that P becomes the origin.
inline Sphere<double> seen_from(const Vec3<double>& P, const Sphere<double>& sphere) {
    return {sphere.C - P, sphere.r};
}

/// The error bounds of one ray's test: those of the surface as seen from its start, the origin then. Moving it there
/// rounds each coordinate once, as the formulas do; far from the world's origin the bounds are so much closer.
template <class Shape>
auto errors_for(const Ray<double>& ray, const Shape& surface) {
    return filter::errors(seen_from(ray.P, surface), including({}, {{}, ray.D}));
}

/// Decides whether a ray meets a surface, and which of two it meets first. Correct always. Tries double with an
/// a-priori bound, then Bounded, then BoundedPair, then Exact, each only where the one before leaves the answer open;
/// all of them run the core's own formulas. Surfaces at the same distance are compared exactly; of equals the one
/// listed last wins.
///
/// `Store` keeps the surfaces: `with_surface(number, use)` calls `use` with one of them, and `errors(surface, number,
/// ray)` bounds the rounding of the doubles that decide about it.
template <class Store>
class FilteredPredicates {
public:
    /// With `only_exact` nothing is left to bounds.
    FilteredPredicates(Store store, const SphereRule& sphere_rule, const TriangleRule& triangle_rule, bool only_exact)
        : store_(std::move(store)), sphere_rule_{sphere_rule}, triangle_rule_{triangle_rule}, only_exact_(only_exact) {}

    const Store& store() const { return store_; }

    /// Tests one surface, and makes it the best so far if the ray meets it first of all. `errors` bound the rounding of
    /// this test.
    template <class Shape, class Errors, class Probe>
    void test(std::optional<ProvenHit>& best, const Ray<double>& ray, const Shape& shape, std::size_t surface,
              const Errors& errors, Probe& probe) const {
        DecidingNumbers numbers{probe, sides_decide()};
        intersect(ray, shape, rule_for(shape), numbers);
        const bool is_missed = numbers.of_a_miss > deciding(errors);
        if (!is_missed) consider(best, ray, surface, probe);
    }
    template <class Shape, class Probe>
    void test(std::optional<ProvenHit>& best, const Ray<double>& ray, const Shape& shape, std::size_t surface,
              Probe& probe) const {
        test(best, ray, shape, surface, store_.errors(shape, surface, ray), probe);
    }

    /// Makes a surface the best so far if the ray meets it, and no farther away. For those that `test`, or the engine,
    /// did not prove to be missed.
    template <class Probe>
    [[gnu::noinline]] void consider(std::optional<ProvenHit>& best, const Ray<double>& ray, std::size_t surface,
                                    Probe& probe) const {
        std::optional<ProvenHit> hit = met(ray, surface, probe);
        if (!hit) return;
        probe(told::Met{}, surface, hit->told_t);
        if (!best || is_nearer(ray, *hit, *best)) best = hit;
    }

    /// Whether the ray meets a surface.
    bool is_met(const Ray<double>& ray, std::size_t surface) const {
        const Silent silent;
        return met(ray, surface, silent).has_value();
    }

    /// A surface that the ray is known to meet.
    template <class Probe>
    ProvenHit hit_of(const Ray<double>& ray, std::size_t surface, Probe& probe) const {
        return *met(ray, surface, probe);
    }

    /// The same, where it is known between which two t.
    template <class Probe>
    ProvenHit proven(const Ray<double>& ray, std::size_t surface, double nearest, double farthest, Probe& probe) const {
        const std::optional<double> t =
            store_.with_surface(surface, [&](const auto& shape) { return told_by_filter(ray, shape); });
        if (!t) return *met(ray, surface, probe);
        return {surface, {*t, not_bounded}, *t, nearest, farthest};
    }

    /// t of a surface that the ray meets, in double: the same whatever else the ray meets.
    double t_of(const Ray<double>& ray, std::size_t surface) const {
        const Silent silent;
        return met(ray, surface, silent)->told_t;
    }

    /// A t good enough for the normal of a surface that the ray is known to meet, `about` there: that which `met` would
    /// tell of a sphere, unless `exact_normal` is asked anyway. A triangle's normal is the same everywhere.
    double t_for_normal(const Ray<double>& ray, std::size_t surface, double about) const {
        const std::optional<double> t = store_.with_surface(surface, [&](const auto& shape) -> std::optional<double> {
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(shape)>, Triangle<double>>) return about;
            else if (is_far_off(ray, shape)) return about;
            else return told_by_filter(ray, shape);
        });
        return t ? *t : t_of(ray, surface);
    }

    /// The same hit, its t with a bound.
    ProvenHit with_bound(const Ray<double>& ray, const ProvenHit& hit) const {
        if (hit.t.error != not_bounded) return hit;
        const Silent silent;
        ProvenHit bounded = hit;
        bounded.t = bounded_or_exact(ray, hit.surface, silent)->t;
        return bounded;
    }

    /// t of a surface that the ray meets, nearly as well as a double can say it.
    Bounded sharpened(const Ray<double>& ray, const ProvenHit& hit) const {
        constexpr double good_enough = 0x1p-49;
        const Bounded t = with_bound(ray, hit).t;
        if (t.error <= good_enough * std::abs(t.value)) return t;
        if (!only_exact_)
            if (const Answer finer = by_running_bounds<BoundedPair>(ray, hit.surface); finer.hit)
                if (const Bounded& its = finer.hit->t; its.error <= good_enough * std::abs(its.value)) return its;
        return true_t(ray, hit.surface)->to_bounded();
    }

    /// The true t of a surface, if the ray meets it.
    std::optional<TrueT> true_t(const Ray<double>& ray, std::size_t surface) const {
        return with_rule(surface,
                         [&](const auto& shape, const auto& rule) { return exact_crossing(ray, shape, rule.rule); });
    }

    /// The unit normal where the ray meets a surface.
    Vec3<double> normal_at(const Ray<double>& ray, const Hit<double>& hit) const {
        return store_.with_surface(hit.surface, [&](const auto& shape) { return normal_at(ray, hit.t, shape); });
    }
    template <class Shape>
    Vec3<double> normal_at(const Ray<double>& ray, double t, const Shape& shape) const {
        if (loses_digits(ray, t, shape))
            if (const auto exact = exact_normal(ray, shape, rule_for(shape).rule)) return *exact;
        return glassbox::normal_at(ray, t, shape);
    }

private:
    /// What one stage says of a surface: a hit, a miss (sure, and no hit), or nothing.
    struct Answer {
        bool is_sure = false;
        std::optional<ProvenHit> hit = {};
    };

    /// A probe that passes on what it hears and keeps how far the numbers that decide are on the side of a miss: the
    /// negative of the discriminant, or of side products of both signs the smaller of the two largest; and on that of a
    /// hit.
    template <class Probe>
    struct DecidingNumbers {
        Probe& listener;
        bool sides_decide;
        double of_a_miss = -1, of_a_hit = -1;

        template <class What, class... Values>
        constexpr void operator()(What what, const Values&... values) {
            if constexpr (std::is_same_v<What, told::Discriminant>) {
                of_a_miss = -(values, ...);
                of_a_hit = (values, ...);
            }
            if constexpr (std::is_same_v<What, told::Sides>) {
                if (sides_decide) {
                    of_a_miss = std::min(std::max({values...}), -std::min({values...}));
                    of_a_hit = std::max(std::min({values...}), -std::max({values...}));
                }
            }
            listener(what, values...);
        }
    };
    template <class Probe>
    DecidingNumbers(Probe&, bool) -> DecidingNumbers<Probe>;

    /// Whether the side products are all that decides about a triangle.
    bool sides_decide() const { return std::holds_alternative<Pluecker>(triangle_rule_.rule); }

    /// The rules that `by_filter` knows bounds for.
    static constexpr Stable filtered_rule(const Sphere<double>&) { return {}; }
    static constexpr Pluecker filtered_rule(const Triangle<double>&) { return {}; }

    /// Whether the one that was chosen for such a surface is.
    bool is_filtered(const Sphere<double>&) const { return std::holds_alternative<Stable>(sphere_rule_.rule); }
    bool is_filtered(const Triangle<double>&) const { return sides_decide(); }

    static double deciding(const filter::SphereErrors& errors) { return errors.discriminant; }
    static double deciding(const filter::TriangleErrors& errors) { return errors.side; }

    const Chosen<SphereRule>& rule_for(const Sphere<double>&) const { return sphere_rule_; }
    const Chosen<TriangleRule>& rule_for(const Triangle<double>&) const { return triangle_rule_; }

    /// Calls `use` with the surface of that number and the rule for its kind.
    template <class Use>
    auto with_rule(std::size_t surface, const Use& use) const {
        return store_.with_surface(surface, [&](const auto& shape) { return use(shape, rule_for(shape)); });
    }

    /// Where the ray meets a surface, if it does, by the first stage that is sure.
    template <class Probe>
    std::optional<ProvenHit> met(const Ray<double>& ray, std::size_t surface, Probe& probe) const {
        if (const Answer filtered = by_filter(ray, surface); filtered.is_sure) return filtered.hit;
        return bounded_or_exact(ray, surface, probe);
    }

    template <class Probe>
    std::optional<ProvenHit> bounded_or_exact(const Ray<double>& ray, std::size_t surface, Probe& probe) const {
        if (only_exact_) {
            probe(told::Undecided{}, surface);
            return by_exact(ray, surface);
        }
        // Who hears nothing of it does not mind which of the two comes first, and this one is the faster.
        if constexpr (OnlyFirstHit<Probe>)
            if (const Answer exact = by_doubles_without_rounding(ray, surface); exact.is_sure) return exact.hit;
        if (const Answer bounded = by_bounds(ray, surface); bounded.is_sure) return bounded.hit;
        probe(told::Undecided{}, surface);
        if constexpr (!OnlyFirstHit<Probe>)
            if (const Answer exact = by_doubles_without_rounding(ray, surface); exact.is_sure) return exact.hit;
        if (const Answer finer = by_running_bounds<BoundedPair>(ray, surface); finer.is_sure) return finer.hit;
        return by_exact(ray, surface);
    }

    /// Stage 1: plain double beside its a-priori bound. Here it proves hits only; `test` has taken out what it proves
    /// to be missed. The loop over all surfaces is faster when it need not keep t, so the few that are left are done
    /// again.
    Answer by_filter(const Ray<double>& ray, std::size_t surface) const {
        return with_rule(surface, [&](const auto& shape, const auto& rule) -> Answer {
            if (const auto ordinary = at_scale(ray, shape))
                return at_given_scale(by_filter(ordinary->ray, ordinary->shape, rule, surface), ordinary->per_t);
            return by_filter(ray, shape, rule, surface);
        });
    }

    /// t of a surface that the ray surely meets, as `by_filter` tells it; nothing where that may not be sure.
    std::optional<double> told_by_filter(const Ray<double>& ray, const Triangle<double>& triangle) const {
        if (!is_filtered(triangle) || !is_of_ordinary_scale(ray, triangle)) return {};
        const Silent silent;
        DecidingNumbers numbers{silent, true};
        const Crossing<double> plain = intersect(ray, triangle, filtered_rule(triangle), numbers);
        // The engine may be sure of what these side products leave open: then its t is not told by them either.
        const bool is_sure = plain.met && numbers.of_a_hit > errors_for(ray, triangle).side;
        return is_sure ? std::optional(plain.t) : std::nullopt;
    }
    std::optional<double> told_by_filter(const Ray<double>& ray, const Sphere<double>& sphere) const {
        if (!is_filtered(sphere) || !is_of_ordinary_scale(ray, sphere)) return {};
        const Silent silent;
        DecidingNumbers numbers{silent, false};
        const Crossing<double> plain = intersect(ray, sphere, filtered_rule(sphere), numbers);
        const bool is_sure = plain.met && is_surely_met(ray, sphere, errors_for(ray, sphere), numbers.of_a_hit);
        return is_sure ? std::optional(plain.t) : std::nullopt;
    }

    /// By the bounds of this ray, whatever others the store has: so that t is told the same by all searches.
    template <class Shape, class Rule>
    Answer by_filter(const Ray<double>& ray, const Shape& shape, const Rule& rule, std::size_t surface) const {
        const Silent silent;
        DecidingNumbers numbers{silent, sides_decide()};
        const Crossing<double> plain = intersect(ray, shape, rule, numbers);
        if (!plain.met) return {};
        const std::optional<Range> t = sure_range(ray, shape, errors_for(ray, shape), numbers.of_a_hit);
        if (!t) return {};
        return {true, ProvenHit{surface, {plain.t, not_bounded}, plain.t, t->least, t->most}};
    }

    /// At an ordinary scale, unless the rule has a length of its own.
    template <class Shape>
    std::optional<AtOrdinaryScale<Shape>> at_scale(const Ray<double>& ray, const Shape& shape) const {
        if constexpr (std::is_same_v<Shape, Triangle<double>>)
            if (std::holds_alternative<Tolerance>(triangle_rule_.rule)) return {};
        return at_ordinary_scale(ray, shape);
    }

    /// An answer whose t are multiplied by a power of two; none where that loses digits.
    static Answer at_given_scale(Answer answer, double per_t) {
        if (!answer.hit) return answer;
        const auto fits = [&](double t) { return std::abs(t * per_t) > 0x1p-900 && std::abs(t * per_t) < 0x1p900; };
        ProvenHit& hit = *answer.hit;
        if (!fits(hit.told_t) || !fits(hit.nearest) || !fits(hit.farthest)) return {};
        hit.t = {hit.t.value * per_t, hit.t.error * per_t + 0x1p-1021};
        hit.told_t *= per_t;
        hit.nearest *= per_t;
        hit.farthest *= per_t;
        return answer;
    }

    /// Stage 2: running bounds.
    Answer by_bounds(const Ray<double>& ray, std::size_t surface) const {
        return by_running_bounds<Bounded>(ray, surface);
    }

    /// By a scalar that carries a bound on its own error.
    template <class Number>
    Answer by_running_bounds(const Ray<double>& ray, std::size_t surface) const {
        return with_rule(surface, [&](const auto& shape, const auto& rule) {
            const auto ordinary = at_scale(ray, shape);
            if (!ordinary) return by_running_bounds<Number>(ray, shape, rule, surface);
            return at_given_scale(by_running_bounds<Number>(ordinary->ray, ordinary->shape, rule, surface),
                                  ordinary->per_t);
        });
    }

    /// The usual rules are called by themselves, and not as one of several, so that all of their arithmetic becomes one
    /// piece of code.
    template <class Number, class Shape, class Rule>
    [[gnu::flatten, gnu::noinline]] static Crossing<Number> crossing_in(const Ray<double>& ray, const Shape& shape,
                                                                        const Rule& rule) {
        const Silent silent;
        const Ray<Number> its_ray = convert<Number>(ray);
        const auto its_shape = convert<Number>(shape);
        using Usual = decltype(filtered_rule(shape));
        if (std::holds_alternative<Usual>(rule.rule)) return intersect(its_ray, its_shape, Usual{}, silent);
        return intersect(its_ray, its_shape, rule, silent);
    }

    template <class Number, class Shape, class Rule>
    static Answer by_running_bounds(const Ray<double>& ray, const Shape& shape, const Rule& rule, std::size_t surface) {
        const Crossing<Number> crossing = crossing_in<Number>(ray, shape, rule);
        if (!possibly(crossing.met)) return {true, {}};
        if (!surely(crossing.met)) return {};
        return {true, hit_at(surface, to_bounded(crossing.t))};
    }
    static Bounded to_bounded(const Bounded& t) { return t; }
    static Bounded to_bounded(const BoundedPair& t) { return t.to_bounded(); }

    /// Where doubles happen to hold all digits of the side products their signs are exact, zeros too. Before stage 3,
    /// which is `by_running_bounds<BoundedPair>`.
    Answer by_doubles_without_rounding(const Ray<double>& ray, std::size_t surface) const {
        return store_.with_surface(surface, [&](const auto& shape) -> Answer {
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(shape)>, Triangle<double>>) {
                if (!sides_decide()) return {};
                const std::optional<Sides<double>> s = unrounded_sides(ray, shape);
                if (!s) return {};
                if (!inside(*s)) return {true, {}};
                const std::optional<Range> t = range(ray, shape, *s, {0, errors_for(ray, shape).distance});
                if (!t || !(t->least > 0 || t->most < 0)) return {};
                if (t->most < 0) return {true, {}};
                const double told_t = plane_t(ray.D, seen_from(ray.P, shape), *s);
                const double error = Bounded::up(std::max(t->most - told_t, told_t - t->least));
                return {true, ProvenHit{surface, {told_t, error}, told_t, t->least, t->most, support(*s)}};
            } else {
                return {};
            }
        });
    }

    /// Stage 4: no rounding at all.
    std::optional<ProvenHit> by_exact(const Ray<double>& ray, std::size_t surface) const {
        const std::optional<TrueT> t = true_t(ray, surface);
        if (!t) return {};
        return hit_at(surface, t->to_bounded());
    }

    static ProvenHit hit_at(std::size_t surface, const Bounded& t) {
        return {surface, t, t.value, t.value - Bounded::up(t.error + 0x1p-51 * std::abs(t.value)),
                Bounded::up(std::abs(t.value) + t.error)};
    }

    /// Between which a number lies.
    struct Range {
        double least, most;
    };

    /// Whether the ray meets a sphere for sure, by Stable's discriminant.
    ///
    /// Where Δ is surely positive and P surely outside, v² − r² > 0, (v·D)² = Δ + D²(v² − r²) is so far from 0 that v·D
    /// has the right sign, too: both roots lie on the side that it tells. Where P is surely inside, one root lies
    /// ahead. Stable finds roots of the right signs in both cases; Textbook, which cancels, need not.
    static bool is_surely_met(const Ray<double>& ray, const Sphere<double>& sphere, const filter::SphereErrors& errors,
                              double discriminant) {
        const Vec3<double> v = ray.P - sphere.C;
        return discriminant > errors.discriminant && std::abs(dot(v, v) - sphere.r * sphere.r) > errors.power;
    }

    /// Between which t the ray meets a sphere, if it does so for sure. No point of the sphere is farther off than its
    /// centre and its radius together, nor nearer than they differ: | |v| − r | ≤ |tD| ≤ |v| + r.
    std::optional<Range> sure_range(const Ray<double>& ray, const Sphere<double>& sphere,
                                    const filter::SphereErrors& errors, double discriminant) const {
        if (!is_filtered(sphere) || !is_surely_met(ray, sphere, errors, discriminant)) return {};
        const Vec3<double> v = ray.P - sphere.C;
        const double distance = length(v), per_D = 1 / length(ray.D);
        return Range{(std::abs(distance - sphere.r) - 0x1p-40 * (distance + sphere.r)) * per_D * (1 - 0x1p-40),
                     (distance + sphere.r) * per_D * (1 + 0x1p-40)};
    }

    /// Between which t the ray meets a triangle, if it does so for sure.
    ///
    /// Where the side products are surely of one sign the line goes through the triangle. t is the mean of the
    /// vertices' tᵢ = D·A/D², weighted by the side products wᵢ. If these are wrong by E at most, the mean is by Σ(ŵᵢ −
    /// wᵢ)(tᵢ − t)/Σwᵢ: no more than 3E (max t − min t)/(Σ|ŵ| − 3E); tᵢ is by errors.distance/D². What else is rounded
    /// is less than 2⁻⁴⁵ of the largest tᵢ. Where the weights are no larger than their errors their sum may be anything
    /// above 0, and there is no bound. The ray meets the triangle where all of that range lies ahead.
    std::optional<Range> sure_range(const Ray<double>& ray, const Triangle<double>& triangle,
                                    const filter::TriangleErrors& errors, double least_side) const {
        if (!(least_side > errors.side)) return {};
        const std::optional<Range> t = range(ray, triangle, sides(ray.D, seen_from(ray.P, triangle)), errors);
        return t && t->least > 0 ? t : std::nullopt;
    }

    /// Between which t a line meets a triangle that it passes inside, by side products that are off by errors.side.
    static std::optional<Range> range(const Ray<double>& ray, const Triangle<double>& triangle, const Sides<double>& w,
                                      const filter::TriangleErrors& errors) {
        const auto& [A, B, C] = seen_from(ray.P, triangle);
        const double a = dot(ray.D, A), b = dot(ray.D, B), c = dot(ray.D, C), D2 = dot(ray.D, ray.D);
        const double sum = w.a + w.b + w.c, weights = std::abs(sum) * (1 - 0x1p-45) - 3 * errors.side;
        if (!(weights > 0x1p-800)) return {};  // no underflow below
        const double nearest = std::min({a, b, c}), farthest = std::max({a, b, c});
        const double middle = (w.a * a + w.b * b + w.c * c) / sum;
        const double off = 3 * errors.side * (farthest - nearest + 2 * errors.distance) / weights + errors.distance +
                           0x1p-45 * std::max(std::abs(nearest), std::abs(farthest));
        const double least = (middle - off) / D2, most = (middle + off) / D2;
        return Range{least - 0x1p-45 * std::abs(least), most + 0x1p-45 * std::abs(most)};
    }

    /// At the same t the surface that is listed last is taken for the nearer.
    bool is_nearer(const Ray<double>& ray, ProvenHit& one, ProvenHit& other) const {
        if (one.nearest > other.farthest) return false;
        if (one.farthest < other.nearest) return true;
        if (meet_in_one_point(one, other)) return one.surface > other.surface;
        one = with_bound(ray, one);
        other = with_bound(ray, other);
        if (surely(one.t > other.t)) return false;
        if (surely(one.t < other.t)) return true;
        if (!only_exact_) {
            const std::optional<BoundedPair> finer = t_in_pairs(ray, one.surface), its = t_in_pairs(ray, other.surface);
            if (finer && its && surely(*finer < *its)) return true;
            if (finer && its && surely(*finer > *its)) return false;
        }
        const int order = compare(*true_t(ray, one.surface), *true_t(ray, other.surface));
        return order != 0 ? order < 0 : one.surface > other.surface;
    }

    /// t of a surface that the ray meets, if pairs are sure that it does: else they left open which root counts, too.
    std::optional<BoundedPair> t_in_pairs(const Ray<double>& ray, std::size_t surface) const {
        return with_rule(surface, [&](const auto& shape, const auto& rule) -> std::optional<BoundedPair> {
            const Crossing<BoundedPair> crossing = crossing_in<BoundedPair>(ray, shape, rule);
            if (!surely(crossing.met)) return {};
            return crossing.t;
        });
    }

    /// Whether two hits are one point, as far as it shows without exact arithmetic.
    bool meet_in_one_point(const ProvenHit& one, const ProvenHit& other) const {
        return store_.with_surface(one.surface, [&](const auto& a) {
            return store_.with_surface(other.surface, [&](const auto& b) {
                using Shape = std::remove_cvref_t<decltype(a)>;
                if constexpr (!std::is_same_v<Shape, std::remove_cvref_t<decltype(b)>>) return false;
                else if constexpr (std::is_same_v<Shape, Sphere<double>>) return a.C == b.C && a.r == b.r;
                else return has_corners(b, a, one.support) || has_corners(a, b, other.support) || are_coplanar(a, b);
            });
        });
    }

    static constexpr double not_bounded = std::numeric_limits<double>::infinity();

    Store store_;
    Chosen<SphereRule> sphere_rule_;
    Chosen<TriangleRule> triangle_rule_;
    bool only_exact_;
};

/// What a search proves to be the nearest hit, in the form that PlainSearch returns it; none for an invalid ray.
template <class Search, class Probe>
std::optional<Hit<double>> nearest_hit(const Search& search, const Ray<double>& ray, Probe& probe) {
    if (!is_valid(ray)) return {};
    const std::optional<ProvenHit> hit = search.trace_proven(ray, probe);
    if (!hit) return {};
    return Hit<double>{hit->surface, hit->told_t};
}

}  // namespace glassbox
