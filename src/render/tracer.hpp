#pragma once
#include <optional>
#include <type_traits>
#include <vector>

#include <ray_color.hpp>
#include <shading.hpp>

#include "render/certified_search.hpp"
#include "render/options.hpp"
#include "render/search.hpp"

namespace glassbox {

namespace told {
struct Nearest {};        ///< (surface, t): what the ray meets first
struct SurfaceNormal {};  ///< the unit normal there
}  // namespace told

/// Colours pixels: a search for what a ray meets, and how that looks.
template <class Search>
struct Tracer {
    using Real = typename Search::Number;

    Search search;
    std::vector<Rgb> colors;
    Rgb background;
    Light<Real> light;
    Shading<Real> shading;
    int stage;

    /// The colour of the pixel in column j and row i, whose ray this is, as far as the stage goes.
    template <class Probe>
    Rgb color(const Ray<Real>& ray, int j, int i, Probe& probe) const {
        if (stage == 1) return rounded(ray_color(ray, j, i));
        const std::optional<Hit<Real>> hit = search.trace(ray, probe);
        if (!hit) return background;
        probe(told::Nearest{}, hit->surface, hit->t);
        const Vec3<Real> n = search.normal_at(ray, *hit);
        probe(told::SurfaceNormal{}, n);
        const Rgb own = colors[hit->surface];
        if (stage < 4) return own;
        return to_rgb(shade(n, unit(-ray.D), to_vec3<Real>(own), light, shading, probe), shading.model);
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

/// Calls `use(search)` with the search for a scene's surfaces that the options name. `reach` covers all rays to come.
template <class Use>
auto with_search(const Scene& scene, const Options& options, const Reach& reach, const Use& use) {
    return std::visit(
        [&]<class Roots, class Test>(const Roots& roots, const Test& test) {
            const auto plain = [&]<class Real>(std::type_identity<Real>) {
                return use(PlainSearch<Real, Roots, Test>{surfaces<Real>(scene, options.stage), roots, test});
            };
            switch (options.scalar) {
                case Scalar::float_:
                    return plain(std::type_identity<float>{});
                case Scalar::double_:
                    return plain(std::type_identity<double>{});
                case Scalar::long_double:
                    return plain(std::type_identity<long double>{});
                case Scalar::certified:
                case Scalar::exact:
                    break;
            }
            return use(CertifiedSearch<Roots, Test>(surfaces<double>(scene, options.stage), roots, test, reach,
                                                    options.scalar == Scalar::exact));
        },
        options.sphere_rule, options.triangle_rule);
}

/// Calls `use(tracer)` with the tracer that the options name.
template <class Use>
auto with_tracer(const Scene& scene, const Options& options, const Reach& reach, const Use& use) {
    return with_search(scene, options, reach, [&]<class Search>(Search&& search) {
        using Real = typename Search::Number;
        const Light<Real> light =
            directional_light(convert<Real>(scene.light_position), static_cast<Real>(scene.light_intensity));
        return use(Tracer<Search>{std::move(search), surface_colors(scene), scene.background, light,
                                  convert<Real>(scene.shading), options.stage});
    });
}

}  // namespace glassbox
