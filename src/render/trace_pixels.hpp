#pragma once
#include "render/parallel.hpp"
#include "render/search/with_tracer.hpp"
#include "render/tiles.hpp"
#include "render/view.hpp"

namespace glassbox {

/// Traces the ray of every pixel on the job's threads, and passes its colour and its probe to `keep(x, y, ray, color,
/// probe)`. With the engine, and a probe that ignores the tests, traces neighbouring rays together. Throws Cancelled.
template <class Probe, class Keep>
void trace_pixels(const Scene& scene, const Options& options, const Job& job, const Keep& keep) {
    const View seen = view(scene, options);
    const RayBounds all = reach(seen, scene.width, scene.height);
    with_tracer<Probe>(scene, options, all, job, [&]<class Search>(const Tracer<Search>& tracer) {
        const auto one_by_one = [&](int x, int y) {
            const Ray<double> ray = pixel_ray(seen, x, y, scene.height);
            Probe probe;
            const Rgb color = tracer.color(convert<typename Search::Number>(ray), x, scene.height - 1 - y, probe);
            keep(x, y, ray, color, probe);
        };
        if constexpr (OnlyNearest<Probe> && OnlyVerdicts<Probe> && requires { tracer.search.engine(); }) {
            if (options.stage > 1) {
                trace_tiles(tracer.search.engine(), seen, scene.width, scene.height, job,
                            [&](int x, int y, std::uint32_t surface, double t) {
                                if (surface == engine::not_told) return one_by_one(x, y);
                                const Ray<double> ray = pixel_ray(seen, x, y, scene.height);
                                Probe probe;
                                if (surface == engine::no_surface) return keep(x, y, ray, tracer.background, probe);
                                // A sphere's normal depends on the exact point; a triangle's is the same everywhere.
                                const bool is_sphere = surface < tracer.search.engine().spheres().size();
                                const double its_t = is_sphere ? tracer.search.t_of(ray, surface) : t;
                                keep(x, y, ray, tracer.color_of(ray, {surface, its_t}, probe), probe);
                            });
                return;
            }
        }
        for_each_pixel(scene.width, scene.height, job, one_by_one);
    });
}

}  // namespace glassbox
