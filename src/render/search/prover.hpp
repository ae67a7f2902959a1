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

/// Decides about one ray and one surface, and which of two is nearer, and is right: plain double where an a-priori
/// bound decides, running bounds where it does not or two hits must be told apart, exact arithmetic where they do not
/// either. All three run the core's own formulas. Surfaces at the same distance are told apart exactly; of equals the
/// one listed last wins.
///
/// `Store` keeps the surfaces: `with_surface(number, use)` calls `use` with one of them, and `errors(surface, number,
/// ray)` bounds the rounding of the doubles that decide about it.
template <class Store>
class Prover {
public:
    /// With `only_exact` nothing is left to bounds.
    Prover(Store store, const SphereRule& sphere_rule, const TriangleRule& triangle_rule, bool only_exact)
        : store_(std::move(store)), sphere_rule_{sphere_rule}, triangle_rule_{triangle_rule}, only_exact_(only_exact) {}

    const Store& store() const { return store_; }

    /// Tests one surface, and takes it for the best so far if the ray meets it first of all.
    template <class Shape, class Probe>
    void test(std::optional<ProvenHit>& best, const Ray<double>& ray, const Shape& shape, std::size_t surface,
              Probe& probe) const {
        Evidence evidence{probe, sides_decide()};
        intersect(ray, shape, rule_for(shape), evidence);
        if (!(evidence.of_a_miss > deciding(store_.errors(shape, surface, ray)))) consider(best, ray, surface, probe);
    }

    /// Takes a surface that may not be missed for the best so far if the ray meets it, and no farther away.
    template <class Probe>
    [[gnu::noinline]] void consider(std::optional<ProvenHit>& best, const Ray<double>& ray, std::size_t surface,
                                    Probe& probe) const {
        std::optional<ProvenHit> hit = sure_hit(ray, surface);
        if (!hit) hit = crossing(ray, surface, probe);
        if (!hit) return;
        probe(told::Met{}, surface, hit->told_t);
        if (!best || !is_farther(ray, *hit, *best)) best = hit;
    }

    /// t of a surface that the ray meets, in double: the same whatever else the ray meets.
    double t_of(const Ray<double>& ray, std::size_t surface) const {
        const Silent silent;
        std::optional<ProvenHit> hit = sure_hit(ray, surface);
        if (!hit) hit = crossing(ray, surface, silent);
        return hit->told_t;
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
        return store_.with_surface(hit.surface,
                                   [&](const auto& surface) { return glassbox::normal_at(ray, hit.t, surface); });
    }

private:
    /// Hands on what it is told, and keeps how far the numbers that decide are on the side of a miss: the negative of
    /// the discriminant, or for side products of both signs the smaller of the two largest; and on that of a hit.
    template <class Probe>
    struct Evidence {
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
    Evidence(Probe&, bool) -> Evidence<Probe>;

    /// Whether the side products are all that decides about a triangle.
    bool sides_decide() const { return std::holds_alternative<Pluecker>(triangle_rule_.rule); }

    static double deciding(const filter::SphereErrors& errors) { return errors.discriminant; }
    static double deciding(const filter::TriangleErrors& errors) { return errors.side; }

    const Chosen<SphereRule>& rule_for(const Sphere<double>&) const { return sphere_rule_; }
    const Chosen<TriangleRule>& rule_for(const Triangle<double>&) const { return triangle_rule_; }

    /// What plain double says, if it is a hit for sure. Done again for the few surfaces that are not missed: the loop
    /// over all of them is faster when it need not keep t.
    std::optional<ProvenHit> sure_hit(const Ray<double>& ray, std::size_t surface) const {
        return with_rule(surface, [&](const auto& shape, const auto& rule) -> std::optional<ProvenHit> {
            const Silent silent;
            Evidence evidence{silent, sides_decide()};
            const Crossing<double> plain = intersect(ray, shape, rule, evidence);
            if (!plain.met) return {};
            const auto& errors = store_.errors(shape, surface, ray);
            if (!is_sure(ray, shape, errors, evidence.of_a_hit)) return {};
            return ProvenHit{surface, {plain.t, not_bounded}, plain.t, farthest(ray, shape, errors, plain.t)};
        });
    }

    /// Where Δ is surely positive and P surely outside, v² − r² > 0, (v·D)² = Δ + D²(v² − r²) is so far from 0 that v·D
    /// has the right sign, too: both roots lie on the side that it tells. Where P is surely inside, one root lies
    /// ahead. Stable finds roots of the right signs in both cases; Textbook, which cancels, need not.
    bool is_sure(const Ray<double>& ray, const Sphere<double>& sphere, const filter::SphereErrors& errors,
                 double discriminant) const {
        if (!std::holds_alternative<Stable>(sphere_rule_.rule) || !(discriminant > errors.discriminant)) return false;
        const Vec3<double> v = ray.P - sphere.c;
        return std::abs(dot(v, v) - sphere.r * sphere.r) > errors.power;
    }

    /// Where the side products are surely of one sign the line goes through the triangle, and where each vertex lies
    /// surely ahead so does their weighted mean, the point that it meets.
    static bool is_sure(const Ray<double>& ray, const Triangle<double>& triangle, const filter::TriangleErrors& errors,
                        double least_side) {
        if (!(least_side > errors.side)) return false;
        const auto& [A, B, C] = seen_from(ray.P, triangle);
        return std::min({dot(ray.D, A), dot(ray.D, B), dot(ray.D, C)}) > errors.distance;
    }

    /// No point of a sphere is farther off than its centre and its radius together: |tD| ≤ |c − P| + r.
    static double farthest(const Ray<double>& ray, const Sphere<double>& sphere, const filter::SphereErrors&, double) {
        return (length(sphere.c - ray.P) + sphere.r) / length(ray.D) * (1 + 0x1p-40);
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

    Crossing<Bounded> bounded_crossing(const Ray<double>& ray, std::size_t surface) const {
        return with_rule(surface, [&](const auto& shape, const auto& rule) {
            const Silent silent;
            return intersect(convert<Bounded>(ray), convert<Bounded>(shape), rule, silent);
        });
    }

    /// Calls `use` with the surface of that number and the rule for its kind.
    template <class Use>
    auto with_rule(std::size_t surface, const Use& use) const {
        return store_.with_surface(surface, [&](const auto& shape) { return use(shape, rule_for(shape)); });
    }

    /// Where the ray meets the surface, if it does: with a bound.
    template <class Probe>
    std::optional<ProvenHit> crossing(const Ray<double>& ray, std::size_t surface, Probe& probe) const {
        const auto hit = [&](const Bounded& t) {
            return ProvenHit{surface, t, t.value, Bounded::up(std::abs(t.value) + t.error)};
        };
        if (!only_exact_) {
            const Crossing<Bounded> bounded = bounded_crossing(ray, surface);
            if (!possibly(bounded.met)) return {};
            if (surely(bounded.met)) return hit(bounded.t);
        }
        probe(told::Undecided{}, surface);
        const std::optional<TrueT> t = true_t(ray, surface);
        if (!t) return {};
        return hit(t->to_bounded());
    }

    /// The same hit, its t with a bound.
    ProvenHit with_bound(const Ray<double>& ray, const ProvenHit& hit) const {
        if (hit.t.error != not_bounded) return hit;
        const Silent silent;
        ProvenHit bounded = hit;
        bounded.t = crossing(ray, hit.surface, silent)->t;
        return bounded;
    }

    /// Bounds both t where it has to. At the same t the one that is listed first is taken for the farther.
    bool is_farther(const Ray<double>& ray, ProvenHit& one, ProvenHit& other) const {
        one = with_bound(ray, one);
        other = with_bound(ray, other);
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

}  // namespace glassbox
