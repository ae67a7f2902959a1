#pragma once
#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include <probe.hpp>

#include "numerics/filter.hpp"
#include "render/exact_crossing.hpp"
#include "render/search.hpp"

namespace glassbox {

namespace told {
struct Undecided {};  ///< (surface): error bounds could not tell whether the ray meets it; exact arithmetic did
}  // namespace told

/// A hit whose t is known within a bound.
struct ProvenHit {
    std::size_t surface;
    Bounded t;
};

/// Finds what a ray meets first, and is right: plain double where an a-priori bound decides, running bounds where it
/// does not, exact arithmetic where they do not either. All three run the core's own formulas. Surfaces at the same
/// distance are told apart exactly; of equals the one listed last wins.
template <class SphereRoots, class TriangleTest>
class CertifiedSearch {
public:
    using Number = double;

    /// `reach` must cover all rays that will be traced. With `only_exact` nothing is left to bounds.
    CertifiedSearch(Surfaces<double> surfaces, const SphereRoots& sphere_roots, const TriangleTest& triangle_test,
                    const Reach& reach, bool only_exact)
        : plain_{std::move(surfaces), sphere_roots, triangle_test}, only_exact_(only_exact) {
        for (const Sphere<double>& sphere : plain_.surfaces.spheres)
            sphere_errors_.push_back(only_exact ? filter::never : filter::discriminant_error(sphere, reach));
        for (const Triangle<double>& triangle : plain_.surfaces.triangles)
            triangle_errors_.push_back(only_exact ? filter::never : filter::sides_error(triangle, reach));
    }

    /// `ray` must be valid.
    template <class Probe>
    std::optional<ProvenHit> trace_proven(const Ray<double>& ray, Probe& probe) const {
        std::optional<ProvenHit> best;
        const auto& [spheres, triangles] = plain_.surfaces;
        for (std::size_t i = 0; i < spheres.size(); ++i) {
            Evidence evidence{probe};
            intersect(ray, spheres[i], plain_.sphere_roots, evidence);
            if (!(evidence.of_a_miss > sphere_errors_[i])) consider(best, ray, i, probe);
        }
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            Evidence evidence{probe};
            intersect(ray, triangles[i], plain_.triangle_test, evidence);
            if (!(evidence.of_a_miss > triangle_errors_[i])) consider(best, ray, spheres.size() + i, probe);
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
        if (hit.t.error <= good_enough * std::abs(hit.t.value)) return hit.t;
        return true_t(ray, hit.surface)->to_bounded();
    }

    /// The true t of a surface, if the ray meets it.
    std::optional<Exact> true_t(const Ray<double>& ray, std::size_t surface) const {
        return with_rule(surface,
                         [&](const auto& shape, const auto& rule) { return exact_crossing(ray, shape, rule); });
    }

private:
    /// Hands on what it is told, and keeps how far the numbers that decide are on the side of a miss: the negative of
    /// the discriminant, or for side products of both signs the smaller of the two largest.
    template <class Probe>
    struct Evidence {
        Probe& listener;
        double of_a_miss = -1;

        template <class What, class... Values>
        constexpr void operator()(What what, const Values&... values) {
            if constexpr (std::is_same_v<What, told::Discriminant>) of_a_miss = -(values, ...);
            if constexpr (std::is_same_v<What, told::Sides> && std::is_same_v<TriangleTest, Pluecker>)
                of_a_miss = std::min(std::max({values...}), -std::min({values...}));
            listener(what, values...);
        }
    };
    template <class Probe>
    Evidence(Probe&) -> Evidence<Probe>;

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

    /// Takes a surface that the filter let pass for the best so far if the ray meets it, and no farther away.
    template <class Probe>
    [[gnu::noinline]] void consider(std::optional<ProvenHit>& best, const Ray<double>& ray, std::size_t surface,
                                    Probe& probe) const {
        const std::optional<Bounded> t = crossing_t(ray, surface, probe);
        if (!t) return;
        probe(told::Met{}, surface, t->value);
        if (!best || !is_farther(ray, {surface, *t}, *best)) best = ProvenHit{surface, *t};
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

    bool is_farther(const Ray<double>& ray, const ProvenHit& one, const ProvenHit& other) const {
        const Kleene farther = one.t > other.t;
        if (surely(farther)) return true;
        if (!possibly(farther)) return false;
        return compare(*true_t(ray, one.surface), *true_t(ray, other.surface)) > 0;
    }

    PlainSearch<double, SphereRoots, TriangleTest> plain_;
    std::vector<double> sphere_errors_, triangle_errors_;
    bool only_exact_;
};

}  // namespace glassbox
