#pragma once
#include <optional>
#include <vector>

#include <crossing.hpp>
#include <ray_color.hpp>
#include <shade_by_model.hpp>

#include "render/tracer_told.hpp"
#include "scene/coefficients.hpp"

namespace glassbox {

/// Computes pixel colours: searches for what a ray meets, and shades it.
template <class Search>
struct Tracer {
    using Real = typename Search::Number;

    Search search;
    std::vector<Rgb> colors;
    Rgb background;
    Light<Real> light;
    Shading<Real> shading;
    int stage;

    /// The colour of the pixel in column j and row i, whose ray this is, as the stage computes it.
    template <class Probe>
    Rgb color(const Ray<Real>& ray, int j, int i, Probe& probe) const {
        if (stage == 1) return rounded(ray_color(ray, j, i));
        const std::optional<Hit<Real>> hit = search.trace(ray, probe);
        return hit ? color_of(ray, *hit, probe) : background;
    }

    /// The colour of what a ray meets first.
    template <class Probe>
    Rgb color_of(const Ray<Real>& ray, const Hit<Real>& hit, Probe& probe) const {
        probe(told::Nearest{}, hit.surface, hit.t);
        const Vec3<Real> n = search.normal_at(ray, hit);
        probe(told::SurfaceNormal{}, n);
        const Rgb own = colors[hit.surface];
        if (stage < 4) return own;
        return to_rgb(shade_by_model(n, unit(-ray.D), to_vec3<Real>(own), light, shading, probe), shading.model);
    }
};

/// The same shading in another scalar.
template <class To, class From>
Shading<To> convert(const Shading<From>& s) {
    return converted<To>(
        s, [](const From& number, auto) { return static_cast<To>(number); },
        [](const Vec3<From>& color, auto) { return convert<To>(color); });
}

}  // namespace glassbox
