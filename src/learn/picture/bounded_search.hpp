#pragma once
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <bounded.hpp>
#include <crossing.hpp>
#include <filter.hpp>
#include <intersect_sphere.hpp>
#include <intersect_triangle.hpp>
#include <probe.hpp>

#include "render/search/surface_normal.hpp"
#include "render/search/surfaces.hpp"

namespace glassbox::learn::mine {

struct LeftOpen {};  ///< the bounds cannot decide whether a surface is met, or which of two is nearer

/// Finds what a ray meets first by the bounds of lesson 6 alone, perhaps a learner's: plain double where the filter
/// proves a miss, else running bounds. It is the certified search without exact arithmetic: what the bounds cannot
/// decide stays undecided.
template <class SphereRoots, class TriangleTest>
class BoundedSearch {
public:
    using Number = double;

    BoundedSearch(Surfaces<double> surfaces, const SphereRoots& roots, const TriangleTest& test, const RayBounds& reach)
        : surfaces_(std::move(surfaces)), roots_(roots), test_(test) {
        for (const auto& sphere : surfaces_.spheres) deciding_.push_back(filter::errors(sphere, reach).discriminant);
        for (const auto& triangle : surfaces_.triangles) deciding_.push_back(filter::errors(triangle, reach).side);
    }

    template <class Probe>
    std::optional<Hit<double>> trace(const Ray<double>& ray, Probe& probe) const {
        std::optional<Hit<Bounded>> best;
        for (std::size_t i = 0; i < surfaces_.spheres.size(); ++i)
            consider(best, ray, surfaces_.spheres[i], roots_, i, probe);
        for (std::size_t i = 0; i < surfaces_.triangles.size(); ++i)
            consider(best, ray, surfaces_.triangles[i], test_, surfaces_.spheres.size() + i, probe);
        if (!best) return {};
        return Hit<double>{best->surface, best->t.value};
    }

    Vec3<double> normal_at(const Ray<double>& ray, const Hit<double>& hit) const {
        return with_surface(surfaces_, hit.surface,
                            [&](const auto& surface) { return glassbox::normal_at(ray, hit.t, surface); });
    }

private:
    /// How far the deciding number is on the side of a miss, as in the certified search's DecidingNumber.
    struct OfAMiss {
        double by = -1;

        template <class What, class... Values>
        void operator()(What, const Values&... values) {
            if constexpr (std::is_same_v<What, told::Discriminant>) by = -(values, ...);
            if constexpr (std::is_same_v<What, told::Sides> && std::is_same_v<TriangleTest, Pluecker>)
                by = std::min(std::max({values...}), -std::min({values...}));
        }
    };

    template <class Surface, class Rule, class Probe>
    void consider(std::optional<Hit<Bounded>>& best, const Ray<double>& ray, const Surface& surface, const Rule& rule,
                  std::size_t number, Probe& probe) const {
        OfAMiss miss;
        intersect(ray, surface, rule, miss);
        if (miss.by > deciding_[number]) return;
        const Silent silent;
        const Crossing<Bounded> crossing = intersect(convert<Bounded>(ray), convert<Bounded>(surface), rule, silent);
        if (!possibly(crossing.met)) return;
        if (!surely(crossing.met)) return probe(LeftOpen{});
        if (best && surely(best->t < crossing.t)) return;
        if (best && possibly(best->t < crossing.t)) probe(LeftOpen{});
        best = Hit<Bounded>{number, crossing.t};
    }

    Surfaces<double> surfaces_;
    SphereRoots roots_;
    TriangleTest test_;
    std::vector<double> deciding_;  ///< the bound on the number that decides, a surface each
};

}  // namespace glassbox::learn::mine
