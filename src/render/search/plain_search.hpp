#pragma once
#include <optional>

#include <crossing.hpp>
#include <ray.hpp>

#include "render/search/surface_normal.hpp"
#include "render/search/surfaces.hpp"

namespace glassbox {

/// Finds the nearest hit by testing all surfaces, one after the other, in one scalar.
template <class Real, class SphereRoots, class TriangleTest>
struct PlainSearch {
    using Number = Real;

    Surfaces<Real> surfaces;
    SphereRoots sphere_roots;
    TriangleTest triangle_test;

    template <class Probe>
    std::optional<Hit<Real>> trace(const Ray<Real>& ray, Probe& probe) const {
        std::optional<Hit<Real>> best;
        std::size_t surface = 0;
        const auto consider = [&](const Crossing<Real>& crossing) {
            if (crossing.met) {
                probe(told::Met{}, surface, crossing.t);
                best = nearest(best, surface, crossing);
            }
            ++surface;
        };
        for (const Sphere<Real>& sphere : surfaces.spheres) consider(intersect(ray, sphere, sphere_roots, probe));
        for (const Triangle<Real>& triangle : surfaces.triangles)
            consider(intersect(ray, triangle, triangle_test, probe));
        return best;
    }

    /// The unit normal where the ray meets the surface.
    Vec3<Real> normal_at(const Ray<Real>& ray, const Hit<Real>& hit) const {
        return with_surface(surfaces, hit.surface,
                            [&](const auto& surface) { return glassbox::normal_at(ray, hit.t, surface); });
    }
};

}  // namespace glassbox
