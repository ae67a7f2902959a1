#pragma once
#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include <probe.hpp>

#include "numerics/filter.hpp"
#include "render/exact_crossing.hpp"
#include "render/search.hpp"

namespace glassbox {

namespace told {
struct Undecided {};  ///< (surface): error bounds could not tell whether the ray meets it; exact arithmetic did
}  // namespace told

/// A hit that is proven. Its t comes with a bound that is infinite until somebody needs one.
struct ProvenHit {
    std::size_t surface;
    Bounded t;
};

/// Finds what a ray meets first, and is right: plain double where an a-priori bound decides, running bounds where it
/// does not or two hits must be told apart, exact arithmetic where they do not either. All three run the core's own
/// formulas. Surfaces at the same distance are told apart exactly; of equals the one listed last wins.
template <class SphereRoots, class TriangleTest>
class CertifiedSearch {
public:
    using Number = double;

    /// `reach` must cover all rays that will be traced. With `only_exact` nothing is left to bounds.
    CertifiedSearch(Surfaces<double> surfaces, const SphereRoots& sphere_roots, const TriangleTest& triangle_test,
                    const Reach& reach, bool only_exact)
        : plain_{std::move(surfaces), sphere_roots, triangle_test}, only_exact_(only_exact) {
        sphere_errors_.resize(plain_.surfaces.spheres.size());
        triangle_errors_.resize(plain_.surfaces.triangles.size());
        if (only_exact) return;
        const auto errors = [&](const auto& surface) { return filter::errors(surface, reach); };
        std::ranges::transform(plain_.surfaces.spheres, sphere_errors_.begin(), errors);
        std::ranges::transform(plain_.surfaces.triangles, triangle_errors_.begin(), errors);
    }

    /// `ray` must be valid.
    template <class Probe>
    std::optional<ProvenHit> trace_proven(const Ray<double>& ray, Probe& probe) const {
        std::optional<ProvenHit> best;
        const auto& [spheres, triangles] = plain_.surfaces;
        for (std::size_t i = 0; i < spheres.size(); ++i) {
            Evidence evidence{probe};
            intersect(ray, spheres[i], plain_.sphere_roots, evidence);
            if (!(evidence.of_a_miss > sphere_errors_[i].discriminant)) consider(best, ray, i, probe);
        }
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            Evidence evidence{probe};
            intersect(ray, triangles[i], plain_.triangle_test, evidence);
            if (!(evidence.of_a_miss > triangle_errors_[i].side)) consider(best, ray, spheres.size() + i, probe);
        }
        return best;
    }

    /// The same as a plain search answers it.
    template <class Probe>
    std::optional<Hit<double>> trace(const Ray<double>& ray, Probe& probe) const {
        if (!is_valid(ray)) return {};
        const std::optional<ProvenHit> hit = trace_proven(ray, probe);
        if (!hit) return {};
        return Hit<double>{hit->surface, hit->t.value};
    }

    Vec3<double> normal_at(const Ray<double>& ray, const Hit<double>& hit) const { return plain_.normal_at(ray, hit); }

    /// t of a surface that the ray meets, nearly as well as a double can say it.
    Bounded sharpened(const Ray<double>& ray, const ProvenHit& hit) const {
        constexpr double good_enough = 0x1p-49;
        const Bounded t = with_bound(ray, hit).t;
        if (t.error <= good_enough * std::abs(t.value)) return t;
        return true_t(ray, hit.surface)->to_bounded();
    }

    /// The true t of a surface, if the ray meets it.
    std::optional<Exact> true_t(const Ray<double>& ray, std::size_t surface) const {
        return with_rule(surface,
                         [&](const auto& shape, const auto& rule) { return exact_crossing(ray, shape, rule); });
    }

private:
    /// Hands on what it is told, and keeps how far the numbers that decide are on the side of a miss: the negative of
    /// the discriminant, or for side products of both signs the smaller of the two largest; and on that of a hit.
    template <class Probe>
    struct Evidence {
        Probe& listener;
        double of_a_miss = -1, of_a_hit = -1;

        template <class What, class... Values>
        constexpr void operator()(What what, const Values&... values) {
            if constexpr (std::is_same_v<What, told::Discriminant>) {
                of_a_miss = -(values, ...);
                of_a_hit = (values, ...);
            }
            if constexpr (std::is_same_v<What, told::Sides> && std::is_same_v<TriangleTest, Pluecker>) {
                of_a_miss = std::min(std::max({values...}), -std::min({values...}));
                of_a_hit = std::max(std::min({values...}), -std::max({values...}));
            }
            listener(what, values...);
        }
    };
    template <class Probe>
    Evidence(Probe&) -> Evidence<Probe>;

    /// t of plain double, if it is a hit for sure. Done again for the few surfaces that are not missed: the loop over
    /// all of them is faster when it need not keep t.
    std::optional<Bounded> sure_t(const Ray<double>& ray, std::size_t surface) const {
        return with_rule(surface, [&](const auto& shape, const auto& rule) -> std::optional<Bounded> {
            const Silent silent;
            Evidence evidence{silent};
            const Crossing<double> plain = intersect(ray, shape, rule, evidence);
            if (!plain.met || !is_sure(ray, shape, errors_of(shape, surface), evidence.of_a_hit)) return {};
            return Bounded{plain.t, not_bounded};
        });
    }

    const filter::SphereErrors& errors_of(const Sphere<double>&, std::size_t surface) const {
        return sphere_errors_[surface];
    }
    const filter::TriangleErrors& errors_of(const Triangle<double>&, std::size_t surface) const {
        return triangle_errors_[surface - sphere_errors_.size()];
    }

    /// Where Δ is surely positive and P surely outside, v² − r² > 0, (v·D)² = Δ + D²(v² − r²) is so far from 0 that v·D
    /// has the right sign, too: both roots lie on the side that it tells. Where P is surely inside, one root lies
    /// ahead. Stable finds roots of the right signs in both cases; Textbook, which cancels, need not.
    static bool is_sure(const Ray<double>& ray, const Sphere<double>& sphere, const filter::SphereErrors& errors,
                        double discriminant) {
        if (!std::is_same_v<SphereRoots, Stable> || !(discriminant > errors.discriminant)) return false;
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

    Crossing<Bounded> bounded_crossing(const Ray<double>& ray, std::size_t surface) const {
        return with_rule(surface, [&](const auto& shape, const auto& rule) {
            const Silent silent;
            return intersect(convert<Bounded>(ray), convert<Bounded>(shape), rule, silent);
        });
    }

    /// Calls `use` with the surface of that number and the rule for its kind.
    template <class Use>
    auto with_rule(std::size_t surface, const Use& use) const {
        return with_surface(plain_.surfaces, surface, [&]<class Surface>(const Surface& shape) {
            if constexpr (std::is_same_v<Surface, Sphere<double>>) return use(shape, plain_.sphere_roots);
            else return use(shape, plain_.triangle_test);
        });
    }

    /// Takes a surface that may not be missed for the best so far if the ray meets it, and no farther away.
    template <class Probe>
    [[gnu::noinline]] void consider(std::optional<ProvenHit>& best, const Ray<double>& ray, std::size_t surface,
                                    Probe& probe) const {
        std::optional<Bounded> t = sure_t(ray, surface);
        if (!t) t = crossing_t(ray, surface, probe);
        if (!t) return;
        probe(told::Met{}, surface, t->value);
        ProvenHit hit{surface, *t};
        if (!best || !is_farther(ray, hit, *best)) best = hit;
    }

    /// Where the ray meets the surface, if it does.
    template <class Probe>
    std::optional<Bounded> crossing_t(const Ray<double>& ray, std::size_t surface, Probe& probe) const {
        if (!only_exact_) {
            const Crossing<Bounded> bounded = bounded_crossing(ray, surface);
            if (!possibly(bounded.met)) return {};
            if (surely(bounded.met)) return bounded.t;
        }
        probe(told::Undecided{}, surface);
        const std::optional<Exact> t = true_t(ray, surface);
        if (!t) return {};
        return t->to_bounded();
    }

    /// The same hit, its t with a bound.
    ProvenHit with_bound(const Ray<double>& ray, const ProvenHit& hit) const {
        if (hit.t.error != not_bounded) return hit;
        const Silent silent;
        return {hit.surface, *crossing_t(ray, hit.surface, silent)};
    }

    /// Bounds both t where it has to.
    bool is_farther(const Ray<double>& ray, ProvenHit& one, ProvenHit& other) const {
        one = with_bound(ray, one);
        other = with_bound(ray, other);
        const Kleene farther = one.t > other.t;
        if (surely(farther)) return true;
        if (!possibly(farther)) return false;
        return compare(*true_t(ray, one.surface), *true_t(ray, other.surface)) > 0;
    }

    static constexpr double not_bounded = std::numeric_limits<double>::infinity();

    PlainSearch<double, SphereRoots, TriangleTest> plain_;
    std::vector<filter::SphereErrors> sphere_errors_;
    std::vector<filter::TriangleErrors> triangle_errors_;
    bool only_exact_;
};

}  // namespace glassbox
