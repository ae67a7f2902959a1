#include "bench/plain_loop.hpp"

#include <algorithm>
#include <optional>

#include "engine/tile.hpp"
#include "render/parallel.hpp"
#include "render/search/certified_search.hpp"

namespace glassbox {

namespace {

// Rays and surfaces are tested a hundred or two of each at a time, so that they stay in the cache. Each ray still meets
// all surfaces, in the same order, by the same tests as in CertifiedSearch::trace_proven.
constexpr std::size_t rays_together = 128, surfaces_together = 256;

using Predicates = FilteredPredicates<ListedSurfaces>;

void test_all(const Predicates& predicates, std::span<const Ray<double>> rays, std::span<std::uint32_t> met) {
    const auto& [spheres, triangles] = predicates.store().surfaces;
    const std::size_t count = spheres.size() + triangles.size();
    std::vector<std::optional<ProvenHit>> best(rays.size());
    const Silent silent;
    for (std::size_t first = 0; first < count; first += surfaces_together) {
        const std::size_t end = std::min(count, first + surfaces_together);
        for (std::size_t r = 0; r < rays.size(); ++r)
            for (std::size_t s = first; s < end; ++s)
                with_surface(predicates.store().surfaces, s,
                             [&](const auto& shape) { predicates.test(best[r], rays[r], shape, s, silent); });
    }
    std::transform(best.begin(), best.end(), met.begin(),
                   [](const auto& hit) { return hit ? static_cast<std::uint32_t>(hit->surface) : engine::no_surface; });
}

}  // namespace

std::vector<std::uint32_t> nearest_by_plain_loop(const Scene& scene, std::span<const Ray<double>> rays,
                                                 const Job& job) {
    const CertifiedSearch search(surfaces<double>(scene, 5), {}, {}, reach_of(rays), false);
    std::vector<std::uint32_t> met(rays.size());
    run_parallel(tbb::blocked_range<std::size_t>(0, rays.size(), rays_together), job, [&](const auto& range) {
        throw_if_stopped(job);
        test_all(search.predicates(), rays.subspan(range.begin(), range.size()),
                 std::span(met).subspan(range.begin(), range.size()));
    });
    return met;
}

}  // namespace glassbox
