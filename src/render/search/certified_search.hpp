#pragma once
#include <optional>
#include <vector>

#include "render/search/filtered_predicates.hpp"

namespace glassbox {

/// A list of surfaces, each with error bounds for all rays within reach; computed once, they cost a ray nothing.
struct ListedSurfaces {
    Surfaces<double> surfaces;
    std::vector<filter::SphereErrors> sphere_errors;
    std::vector<filter::TriangleErrors> triangle_errors;

    template <class Use>
    auto with_surface(std::size_t number, const Use& use) const {
        return glassbox::with_surface(surfaces, number, use);
    }
    const filter::SphereErrors& errors(const Sphere<double>&, std::size_t number, const Ray<double>&) const {
        return sphere_errors[number];
    }
    const filter::TriangleErrors& errors(const Triangle<double>&, std::size_t number, const Ray<double>&) const {
        return triangle_errors[number - sphere_errors.size()];
    }
};

/// With `no_bounds`, all bounds are infinite and decide nothing.
inline ListedSurfaces listed(Surfaces<double> surfaces, const RayBounds& reach, bool no_bounds) {
    ListedSurfaces result{std::move(surfaces), {}, {}};
    result.sphere_errors.resize(result.surfaces.spheres.size());
    result.triangle_errors.resize(result.surfaces.triangles.size());
    if (no_bounds) return result;
    const auto errors = [&](const auto& surface) { return filter::errors(surface, reach); };
    std::ranges::transform(result.surfaces.spheres, result.sphere_errors.begin(), errors);
    std::ranges::transform(result.surfaces.triangles, result.triangle_errors.begin(), errors);
    return result;
}

/// Finds the nearest hit, correctly, by testing all surfaces one after the other: see FilteredPredicates.
class CertifiedSearch {
public:
    using Number = double;

    /// `reach` must cover all rays to be traced. With `only_exact`, bounds decide nothing.
    CertifiedSearch(Surfaces<double> surfaces, const SphereRule& sphere_rule, const TriangleRule& triangle_rule,
                    const RayBounds& reach, bool only_exact)
        : predicates_(listed(std::move(surfaces), reach, only_exact), sphere_rule, triangle_rule, only_exact) {}

    /// `ray` must be valid.
    template <class Probe>
    std::optional<ProvenHit> trace_proven(const Ray<double>& ray, Probe& probe) const {
        std::optional<ProvenHit> best;
        const auto& [spheres, triangles] = predicates_.store().surfaces;
        for (std::size_t i = 0; i < spheres.size(); ++i) predicates_.test(best, ray, spheres[i], i, probe);
        for (std::size_t i = 0; i < triangles.size(); ++i)
            predicates_.test(best, ray, triangles[i], spheres.size() + i, probe);
        return best;
    }

    template <class Probe>
    std::optional<Hit<double>> trace(const Ray<double>& ray, Probe& probe) const {
        return nearest_hit(*this, ray, probe);
    }

    /// To ask about single surfaces.
    const FilteredPredicates<ListedSurfaces>& predicates() const { return predicates_; }

    Vec3<double> normal_at(const Ray<double>& ray, const Hit<double>& hit) const {
        return predicates_.normal_at(ray, hit);
    }

private:
    FilteredPredicates<ListedSurfaces> predicates_;
};

}  // namespace glassbox
