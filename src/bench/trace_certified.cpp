#include "bench/against_embree.hpp"
#include "render/pixel.hpp"
#include "render/search/with_tracer.hpp"
#include "render/tiles.hpp"

namespace glassbox {

NearestHits::NearestHits(const Scene& scene) : surface(pixel_count(scene.width, scene.height)), t(surface.size()) {}

namespace {

struct Tracing {
    FastSearch search;
    View view;
    const Scene& scene;
    NearestHits& hits;

    void alone(int x, int y) const {
        const Silent silent;
        const auto hit = search.trace(pixel_ray(view, x, y, scene.height), silent);
        keep(x, y, hit ? static_cast<std::uint32_t>(hit->surface) : engine::no_surface, hit ? hit->t : 0);
    }

    void keep(int x, int y, std::uint32_t surface, double t) const {
        const std::size_t pixel = index_of({x, y}, scene.width);
        hits.surface[pixel] = surface;
        hits.t[pixel] = static_cast<float>(t);
    }
};

}  // namespace

void trace_certified(const Scene& scene, const Job& job, NearestHits& hits) {
    const Tracing tracing{{job.engine, Stable{}, Pluecker{}}, view(scene, {}), scene, hits};
    trace_tiles(*job.engine, tracing.view, scene.width, scene.height, job,
                [&](int x, int y, std::uint32_t surface, double t) {
                    if (surface == engine::not_told) tracing.alone(x, y);
                    else tracing.keep(x, y, surface, t);
                });
}

void trace_certified_one_by_one(const Scene& scene, const Job& job, NearestHits& hits) {
    const Tracing tracing{{job.engine, Stable{}, Pluecker{}}, view(scene, {}), scene, hits};
    for_each_pixel(scene.width, scene.height, job, [&](int x, int y) { tracing.alone(x, y); });
}

}  // namespace glassbox
