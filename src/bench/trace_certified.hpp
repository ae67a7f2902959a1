#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <ray.hpp>

#include "render/job.hpp"
#include "render/view.hpp"

namespace glassbox {

/// What each of many rays meets first: the surface's number or engine::no_surface, and t.
struct NearestHits {
    std::vector<std::uint32_t> surface;
    std::vector<float> t;

    explicit NearestHits(std::size_t rays) : surface(rays), t(rays) {}
};

// With the job's engine, certified.

/// The rays of all pixels, tiles of them together. The hits are in the order of pixels, row by row from the top.
void trace_certified(const View& view, int width, int height, const Job& job, NearestHits& hits);

/// Each ray by itself.
void trace_certified(std::span<const Ray<float>> rays, const Job& job, NearestHits& hits);

/// Whether each ray meets anything.
void occluded_certified(std::span<const Ray<float>> rays, const Job& job, std::vector<std::uint8_t>& answers);

}  // namespace glassbox
