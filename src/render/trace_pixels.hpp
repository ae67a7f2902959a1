#pragma once
#include "render/parallel.hpp"
#include "render/view.hpp"
#include "render/with_tracer.hpp"

namespace glassbox {

/// Traces the ray of every pixel on the job's threads, and hands its colour and its probe to `keep(x, y, ray, color,
/// probe)`. Throws Cancelled.
template <class Probe, class Keep>
void trace_pixels(const Scene& scene, const Options& options, const Job& job, const Keep& keep) {
    const View seen = view(scene, options);
    const Reach all = reach(seen, scene.width, scene.height);
    with_tracer<Probe>(scene, options, all, job, [&]<class Search>(const Tracer<Search>& tracer) {
        for_each_pixel(scene.width, scene.height, job, [&](int x, int y) {
            const Ray<double> ray = pixel_ray(seen, x, y, scene.height);
            Probe probe;
            const Rgb color = tracer.color(convert<typename Search::Number>(ray), x, scene.height - 1 - y, probe);
            keep(x, y, ray, color, probe);
        });
    });
}

}  // namespace glassbox
