#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "render/search/filtered_predicates.hpp"

namespace glassbox {

inline bool is_within(const RayBounds& reach, const Ray<double>& ray) {
    const auto holds = [](const Vec3<double>& most, const Vec3<double>& v) {
        return std::abs(v.x) <= most.x && std::abs(v.y) <= most.y && std::abs(v.z) <= most.z;
    };
    return holds(reach.P, ray.P) && holds(reach.D, ray.D);
}

/// A list of surfaces, each with error bounds for all rays within reach; computed once, they cost a ray nothing. A ray
/// that lies beyond has bounds of its own.
struct ListedSurfaces {
    Surfaces<double> surfaces;
    RayBounds reach;
    std::vector<filter::SphereErrors> sphere_errors;
    std::vector<filter::TriangleErrors> triangle_errors;
    bool no_bounds;  ///< all are infinite, and decide nothing

    template <class Use>
    auto with_surface(std::size_t number, const Use& use) const {
        return glassbox::with_surface(surfaces, number, use);
    }

    const filter::SphereErrors& listed_errors(const Sphere<double>&, std::size_t number) const {
        return sphere_errors[number];
    }
    const filter::TriangleErrors& listed_errors(const Triangle<double>&, std::size_t number) const {
        return triangle_errors[number - sphere_errors.size()];
    }
    template <class Shape>
    auto errors(const Shape& shape, std::size_t number, const Ray<double>& ray) const {
        return no_bounds || is_within(reach, ray) ? listed_errors(shape, number) : errors_for(ray, shape);
    }
};

/// A reach for a list of rays: it holds all of them, but for a few that start much farther off, or have much longer
/// directions, than most. For these the bounds would be so wide that they told nothing of the others.
inline RayBounds reach_of(std::span<const Ray<double>> rays) {
    std::vector<double> starts, directions;
    for (const Ray<double>& ray : rays) {
        if (!is_valid(ray)) continue;
        starts.push_back(filter::greatest({std::abs(ray.P.x), std::abs(ray.P.y), std::abs(ray.P.z)}));
        directions.push_back(filter::greatest({std::abs(ray.D.x), std::abs(ray.D.y), std::abs(ray.D.z)}));
    }
    const auto limit = [](std::vector<double>& sizes) {
        if (sizes.empty()) return 0.0;
        const auto nine_in_ten = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() * 9 / 10);
        std::ranges::nth_element(sizes, nine_in_ten);
        return 16 * *nine_in_ten;
    };
    const double farthest = limit(starts), longest = limit(directions);
    const RayBounds most{{farthest, farthest, farthest}, {longest, longest, longest}};
    RayBounds reach;
    for (const Ray<double>& ray : rays)
        if (is_valid(ray) && is_within(most, ray)) reach = including(reach, ray);
    return reach;
}

/// With `no_bounds`, all bounds are infinite and decide nothing.
inline ListedSurfaces listed(Surfaces<double> surfaces, const RayBounds& reach, bool no_bounds) {
    ListedSurfaces result{std::move(surfaces), reach, {}, {}, no_bounds};
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

    /// Fastest for rays within `reach`. With `only_exact`, bounds decide nothing.
    CertifiedSearch(Surfaces<double> surfaces, const SphereRule& sphere_rule, const TriangleRule& triangle_rule,
                    const RayBounds& reach, bool only_exact)
        : predicates_(listed(std::move(surfaces), reach, only_exact), sphere_rule, triangle_rule, only_exact) {}

    /// `ray` must be valid.
    template <class Probe>
    std::optional<ProvenHit> trace_proven(const Ray<double>& ray, Probe& probe) const {
        std::optional<ProvenHit> best;
        const ListedSurfaces& list = predicates_.store();
        const auto test_all = [&](const auto& errors) {
            const auto& [spheres, triangles] = list.surfaces;
            for (std::size_t i = 0; i < spheres.size(); ++i)
                predicates_.test(best, ray, spheres[i], i, errors(spheres[i], i), probe);
            for (std::size_t i = 0; i < triangles.size(); ++i) {
                const std::size_t number = spheres.size() + i;
                predicates_.test(best, ray, triangles[i], number, errors(triangles[i], number), probe);
            }
        };
        if (list.no_bounds || is_within(list.reach, ray))
            test_all([&](const auto& shape, std::size_t number) -> const auto& {
                return list.listed_errors(shape, number);
            });
        else test_all([&](const auto& shape, std::size_t) { return errors_for(ray, shape); });
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
