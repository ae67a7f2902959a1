#pragma once
#include "render/parallel.hpp"
#include "render/search/with_tracer.hpp"
#include "render/tiles.hpp"
#include "render/view.hpp"

namespace glassbox {

// From scene to pixel: `view` tells where the rays start and where they go; `with_tracer` finds the scalar and the
// search that the options name; and each pixel's ray, `pixel_ray`, is given its colour by the Tracer: Search::trace
// finds what the ray meets first, Tracer::color_of how that looks.

/// The pixels of one picture. A pixel's ray, its colour and its probe are handed to `keep(x, y, ray, color, probe)`.
template <class Probe, class Search, class Keep>
struct Pixels {
    const Tracer<Search>& tracer;
    const View& view;
    int height;
    const Keep& keep;

    /// Traces a pixel's ray by itself.
    void trace(int x, int y) const {
        const Ray<double> ray = pixel_ray(view, x, y, height);
        Probe probe;
        const Rgb color = tracer.color(convert<typename Search::Number>(ray), x, height - 1 - y, probe);
        keep(x, y, ray, color, probe);
    }

    /// Takes from a tile what a pixel's ray meets first: see trace_tiles.
    void take(int x, int y, std::uint32_t surface, double t) const {
        if (surface == engine::not_told) return trace(x, y);
        const Ray<double> ray = pixel_ray(view, x, y, height);
        Probe probe;
        if (surface == engine::no_surface) return keep(x, y, ray, tracer.background, probe);
        const bool is_sphere = surface < tracer.search.engine().sphere_count();
        const double its_t = is_sphere ? tracer.search.predicates().t_for_normal(ray, surface, t) : t;
        keep(x, y, ray, tracer.color_of(ray, {surface, its_t}, probe), probe);
    }
};

template <class Search>
concept HasEngine = requires(const Search& search) {
    search.engine();
};

/// Traces the ray of every pixel on the job's threads, and passes its colour and its probe to `keep(x, y, ray, color,
/// probe)`. With the engine, and a probe that ignores the tests, traces neighbouring rays together. Throws Cancelled.
template <class Probe, class Keep>
void trace_pixels(const Scene& scene, const Options& options, const Job& job, const Keep& keep) {
    const View seen = view(scene, options);
    const RayBounds all = reach(seen, scene.width, scene.height);
    with_tracer<Probe>(scene, options, all, job, [&]<class Search>(const Tracer<Search>& tracer) {
        const Pixels<Probe, Search, Keep> pixels{tracer, seen, scene.height, keep};
        if constexpr (OnlyFirstHit<Probe> && HasEngine<Search>) {
            // Stage 1 knows of no surfaces: its colours are those of the rays themselves.
            if (options.stage > 1)
                return trace_tiles(
                    tracer.search.engine(), seen, scene.width, scene.height, job,
                    [&](int x, int y, std::uint32_t surface, double t) { pixels.take(x, y, surface, t); });
        }
        for_each_pixel(scene.width, scene.height, job, [&](int x, int y) { pixels.trace(x, y); });
    });
}

}  // namespace glassbox
