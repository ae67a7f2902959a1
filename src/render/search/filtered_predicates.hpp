#pragma once
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include <filter.hpp>
#include <probe.hpp>

#include "render/rules.hpp"
#include "render/search/exact_crossing.hpp"
#include "render/search/surface_normal.hpp"
#include "render/search/surfaces.hpp"

namespace glassbox {

namespace told {
struct Undecided {};  ///< (surface): error bounds could not tell whether the ray meets it; exact arithmetic did
}  // namespace told

/// A hit that is proven.
struct ProvenHit {
    std::size_t surface;
    Bounded t;        ///< its bound is infinite until somebody needs one
    double told_t;    ///< t as it was found first: the same whatever else the ray meets
    double farthest;  ///< no true t is beyond this; nearly t, for a triangle that is hit for sure
};

/// Decides whether a ray meets a surface, and which of two it meets first. Correct always. Tries double with an
/// a-priori bound, then Bounded, then Exact, each only where the one before leaves the answer open; all three run the
/// core's own formulas. Surfaces at the same distance are compared exactly; of equals the one listed last wins.
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

    /// Tests one surface, and makes it the best so far if the ray meets it first of all.
    template <class Shape, class Probe>
    void test(std::optional<ProvenHit>& best, const Ray<double>& ray, const Shape& shape, std::size_t surface,
              Probe& probe) const {
        DecidingNumbers numbers{probe, sides_decide()};
        intersect(ray, shape, rule_for(shape), numbers);
        const bool is_missed = numbers.of_a_miss > deciding(store_.errors(shape, surface, ray));
        if (!is_missed) consider(best, ray, surface, probe);
    }

    /// Makes a surface the best so far if the ray meets it, and no farther away. For those that `test`, or the engine,
    /// did not prove to be missed.
    template <class Probe>
    [[gnu::noinline]] void consider(std::optional<ProvenHit>& best, const Ray<double>& ray, std::size_t surface,
                                    Probe& probe) const {
        std::optional<ProvenHit> hit = met(ray, surface, probe);
        if (!hit) return;
        probe(told::Met{}, surface, hit->told_t);
        if (best) {
            *hit = with_bound(ray, *hit);
            *best = with_bound(ray, *best);
            if (is_farther(ray, *hit, *best)) return;
        }
        best = hit;
    }

    /// t of a surface that the ray meets, in double: the same whatever else the ray meets.
    double t_of(const Ray<double>& ray, std::size_t surface) const {
        const Silent silent;
        return met(ray, surface, silent)->told_t;
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
        return true_t(ray, hit.surface)->to_bounded();
    }

    /// The true t of a surface, if the ray meets it.
    std::optional<TrueT> true_t(const Ray<double>& ray, std::size_t surface) const {
        return with_rule(surface,
                         [&](const auto& shape, const auto& rule) { return exact_crossing(ray, shape, rule.rule); });
    }

    /// The unit normal where the ray meets a surface.
    Vec3<double> normal_at(const Ray<double>& ray, const Hit<double>& hit) const {
        return with_rule(hit.surface, [&](const auto& shape, const auto& rule) {
            if (loses_digits(ray, hit.t, shape))
                if (const auto exact = exact_normal(ray, shape, rule.rule)) return *exact;
            return glassbox::normal_at(ray, hit.t, shape);
        });
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
        if (!only_exact_)
            if (const Answer bounded = by_bounds(ray, surface); bounded.is_sure) return bounded.hit;
        probe(told::Undecided{}, surface);
        return by_exact(ray, surface);
    }

    /// Stage 1: plain double beside its a-priori bound. Here it proves hits only; `test` has taken out what it proves
    /// to be missed. The loop over all surfaces is faster when it need not keep t, so the few that are left are done
    /// again.
    Answer by_filter(const Ray<double>& ray, std::size_t surface) const {
        return with_rule(surface, [&](const auto& shape, const auto& rule) -> Answer {
            const Silent silent;
            DecidingNumbers numbers{silent, sides_decide()};
            const Crossing<double> plain = intersect(ray, shape, rule, numbers);
            if (!plain.met) return {};
            const auto& errors = store_.errors(shape, surface, ray);
            if (!is_sure_hit(ray, shape, errors, numbers.of_a_hit)) return {};
            return {true, ProvenHit{surface, {plain.t, not_bounded}, plain.t, farthest(ray, shape, errors, plain.t)}};
        });
    }

    /// Stage 2: running bounds.
    Answer by_bounds(const Ray<double>& ray, std::size_t surface) const {
        const Crossing<Bounded> crossing = with_rule(surface, [&](const auto& shape, const auto& rule) {
            const Silent silent;
            return intersect(convert<Bounded>(ray), convert<Bounded>(shape), rule, silent);
        });
        if (!possibly(crossing.met)) return {true, {}};
        if (!surely(crossing.met)) return {};
        return {true, hit_at(surface, crossing.t)};
    }

    /// Stage 3: no rounding at all.
    std::optional<ProvenHit> by_exact(const Ray<double>& ray, std::size_t surface) const {
        const std::optional<TrueT> t = true_t(ray, surface);
        if (!t) return {};
        return hit_at(surface, t->to_bounded());
    }

    static ProvenHit hit_at(std::size_t surface, const Bounded& t) {
        return {surface, t, t.value, Bounded::up(std::abs(t.value) + t.error)};
    }

    /// Where Δ is surely positive and P surely outside, v² − r² > 0, (v·D)² = Δ + D²(v² − r²) is so far from 0 that v·D
    /// has the right sign, too: both roots lie on the side that it tells. Where P is surely inside, one root lies
    /// ahead. Stable finds roots of the right signs in both cases; Textbook, which cancels, need not.
    bool is_sure_hit(const Ray<double>& ray, const Sphere<double>& sphere, const filter::SphereErrors& errors,
                     double discriminant) const {
        if (!std::holds_alternative<Stable>(sphere_rule_.rule) || !(discriminant > errors.discriminant)) return false;
        const Vec3<double> v = ray.P - sphere.C;
        return std::abs(dot(v, v) - sphere.r * sphere.r) > errors.power;
    }

    /// Where the side products are surely of one sign the line goes through the triangle, and where each vertex lies
    /// surely ahead so does their weighted mean, the point that it meets.
    static bool is_sure_hit(const Ray<double>& ray, const Triangle<double>& triangle,
                            const filter::TriangleErrors& errors, double least_side) {
        if (!(least_side > errors.side)) return false;
        const auto& [A, B, C] = seen_from(ray.P, triangle);
        return std::min({dot(ray.D, A), dot(ray.D, B), dot(ray.D, C)}) > errors.distance;
    }

    /// No point of a sphere is farther off than its centre and its radius together: |tD| ≤ |c − P| + r.
    static double farthest(const Ray<double>& ray, const Sphere<double>& sphere, const filter::SphereErrors&, double) {
        return (length(sphere.C - ray.P) + sphere.r) / length(ray.D) * (1 + 0x1p-40);
    }

    /// t is the mean of the vertices' tᵢ = D·A/D², weighted by the side products wᵢ, here all of one sign. If these are
    /// wrong by E at most, the mean is by Σ(ŵᵢ − wᵢ)(tᵢ − t)/Σwᵢ: no more than 3E (max t − min t)/(Σ|ŵ| − 3E); tᵢ is by
    /// errors.distance/D². What else is rounded is so relatively, as nothing here is negative: by less than 2⁻⁴⁵. Where
    /// the weights are no larger than their errors their sum may be anything above 0, and there is no bound.
    static double farthest(const Ray<double>& ray, const Triangle<double>& triangle,
                           const filter::TriangleErrors& errors, double t) {
        const Triangle<double> seen = seen_from(ray.P, triangle);
        const auto& [A, B, C] = seen;
        const Sides<double> w = sides(ray.D, seen);
        const double a = dot(ray.D, A), b = dot(ray.D, B), c = dot(ray.D, C), D2 = dot(ray.D, ray.D);
        const double weights = std::abs(w.a + w.b + w.c) * (1 - 0x1p-45) - 3 * errors.side;
        if (!(weights > 0)) return not_bounded;
        const double spread = std::max({a, b, c}) - std::min({a, b, c}) + 2 * errors.distance;
        return (t + (3 * errors.side * spread / weights + errors.distance) / D2) * (1 + 0x1p-45);
    }

    /// Of two hits with bounds. At the same t the one that is listed first is taken for the farther.
    bool is_farther(const Ray<double>& ray, const ProvenHit& one, const ProvenHit& other) const {
        if (surely(one.t > other.t)) return true;
        if (surely(one.t < other.t)) return false;
        const int order = compare(*true_t(ray, one.surface), *true_t(ray, other.surface));
        return order != 0 ? order > 0 : one.surface < other.surface;
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
