#include "bench/trace_certified.hpp"

#include "bench/ray_lists.hpp"
#include "render/pixel.hpp"
#include "render/search/fast_search.hpp"
#include "render/tiles.hpp"

namespace glassbox {

namespace {

FastSearch search_of(const Job& job) { return {job.engine, Stable{}, Pluecker{}}; }

void keep(NearestHits& hits, std::size_t place, std::uint32_t surface, double t) {
    hits.surface[place] = surface;
    hits.t[place] = static_cast<float>(t);
}

void trace(const FastSearch& search, const Ray<double>& ray, NearestHits& hits, std::size_t place) {
    const auto hit = search.nearest(ray);
    if (hit) keep(hits, place, static_cast<std::uint32_t>(hit->surface), 0.5 * (hit->low + hit->high));
    else keep(hits, place, engine::no_surface, 0);
}

}  // namespace

void trace_certified(const View& view, int width, int height, const Job& job, NearestHits& hits) {
    const FastSearch search = search_of(job);
    trace_tiles(*job.engine, view, width, height, job, [&](int x, int y, std::uint32_t surface, double t) {
        const std::size_t place = index_of({x, y}, width);
        if (surface == engine::not_told) trace(search, pixel_ray(view, x, y, height), hits, place);
        else keep(hits, place, surface, t);
    });
}

void trace_certified(std::span<const Ray<float>> rays, const Job& job, NearestHits& hits) {
    const FastSearch search = search_of(job);
    for_each_timed(rays.size(), job, [&](std::size_t i) { trace(search, convert<double>(rays[i]), hits, i); });
}

void occluded_certified(std::span<const Ray<float>> rays, const Job& job, std::vector<std::uint8_t>& answers) {
    const FastSearch search = search_of(job);
    for_each_timed(rays.size(), job, [&](std::size_t i) { answers[i] = search.occluded(convert<double>(rays[i])); });
}

}  // namespace glassbox
