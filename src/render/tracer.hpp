#pragma once
#include <optional>
#include <type_traits>
#include <vector>

#include <ray_color.hpp>
#include <shading.hpp>

#include "render/options.hpp"
#include "render/surfaces.hpp"

namespace glassbox {

namespace told {
struct Nearest {};        ///< (surface, t): what the ray meets first
struct SurfaceNormal {};  ///< the unit normal there
}  // namespace told

/// Follows rays through a scene: the core's formulas put together, for one scalar and one rule for each kind of
/// surface.
template <class Real, class SphereRoots, class TriangleTest>
struct Tracer {
    Surfaces<Real> surfaces;
    SphereRoots sphere_roots;
    TriangleTest triangle_test;
    std::vector<Rgb> colors;
    Rgb background;
    Light<Real> light;
    Shading<Real> shading;
    int stage;

    /// What the ray meets first, of all surfaces, one after the other.
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

    /// The colour of the pixel in column j and row i, whose ray this is, as far as the stage goes.
    template <class Probe>
    Rgb color(const Ray<Real>& ray, int j, int i, Probe& probe) const {
        if (stage == 1) return rounded(ray_color(ray, j, i));
        const std::optional<Hit<Real>> hit = trace(ray, probe);
        if (!hit) return background;
        probe(told::Nearest{}, hit->surface, hit->t);
        const Vec3<Real> n = normal_at(*hit, ray);
        probe(told::SurfaceNormal{}, n);
        const Rgb own = colors[hit->surface];
        if (stage < 4) return own;
        return to_rgb(shade(n, unit(-ray.D), to_vec3<Real>(own), light, shading, probe), shading.model);
    }

private:
    Vec3<Real> normal_at(const Hit<Real>& hit, const Ray<Real>& ray) const {
        const std::size_t spheres = surfaces.spheres.size();
        if (hit.surface < spheres) return normal(surfaces.spheres[hit.surface], at(ray, hit.t));
        return normal(surfaces.triangles[hit.surface - spheres]);
    }
};

template <class To, class From>
Shading<To> convert(const Shading<From>& s) {
    return {s.model,
            static_cast<To>(s.k_a),
            static_cast<To>(s.k_d),
            static_cast<To>(s.k_s),
            static_cast<To>(s.exponent),
            convert<To>(s.ambient_color),
            convert<To>(s.specular_color)};
}

/// Calls `use(tracer)` with the tracer that the options name.
template <class Use>
auto with_tracer(const Scene& scene, const Options& options, const Use& use) {
    const auto in_scalar = [&]<class Real>(std::type_identity<Real>) {
        return std::visit(
            [&](const auto& roots, const auto& test) {
                using RootsRule = std::decay_t<decltype(roots)>;
                using Test = std::decay_t<decltype(test)>;
                const Light<Real> light =
                    directional_light(convert<Real>(scene.light_position), static_cast<Real>(scene.light_intensity));
                return use(Tracer<Real, RootsRule, Test>{surfaces<Real>(scene, options.stage), roots, test,
                                                         surface_colors(scene), scene.background, light,
                                                         convert<Real>(scene.shading), options.stage});
            },
            options.sphere_rule, options.triangle_rule);
    };
    switch (options.scalar) {
        case Scalar::float_:
            return in_scalar(std::type_identity<float>{});
        case Scalar::double_:
            return in_scalar(std::type_identity<double>{});
        default:
            return in_scalar(std::type_identity<long double>{});
    }
}

}  // namespace glassbox
