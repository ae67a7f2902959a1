#include "bench/plain_loop.hpp"

#include <algorithm>
#include <optional>

#include "engine/tile.hpp"
#include "render/parallel.hpp"
#include "render/search/certified_search.hpp"

namespace glassbox {

namespace {

// Rays and surfaces are tested a hundred or two of each at a time, so that they stay in the cache. Each ray still meets
// all surfaces, in the same order, by the same tests as in CertifiedSearch::trace_proven, but those that it passes so
// far off that a look at a sphere around them tells.
constexpr std::size_t rays_together = 128, surfaces_together = 256;

using Predicates = FilteredPredicates<ListedSurfaces>;

/// Spheres around surfaces: their middles, and the squares of their radii or a little more.
struct SpheresAround {
    std::vector<double> x, y, z, r2;

    explicit SpheresAround(const Surfaces<double>& surfaces) {
        for (const Sphere<double>& sphere : surfaces.spheres) add(sphere.C, sphere.r);
        for (const auto& [A, B, C] : surfaces.triangles) {
            const Vec3<double> middle = A / 3. + B / 3. + C / 3.;
            add(middle, std::max({length(A - middle), length(B - middle), length(C - middle)}));
        }
    }

private:
    void add(const Vec3<double>& middle, double r) {
        x.push_back(middle.x);
        y.push_back(middle.y);
        z.push_back(middle.z);
        r2.push_back(r * r * (1 + 0x1p-40));
    }
};

/// Tells of some spheres whether the ray's line surely misses them: where the number is positive.
///
/// The line is |c × D|/|D| from the middle c, as seen from the ray's start. In doubles c × D is off by 6u|c||D| at
/// most, u = 2⁻⁵³, which 2⁻⁴⁰|c|² beside r² allows for: (r + 6uc)² ≤ r² + 2⁻⁴⁰c² unless r > 682c, and then nothing is
/// missed. 2⁻¹⁰⁰⁰ hides what underflow takes, but for that of D², whose ray is said to miss nothing; where something
/// overflows, the number is not positive or rightly so.
void find_missed(const SpheresAround& spheres, std::size_t first, std::size_t end, const Ray<double>& ray,
                 double* missed_by) {
    const auto [P, D] = ray;
    const double D2 = dot(D, D);
    if (!(D2 > 0x1p-900)) {
        std::fill(missed_by, missed_by + (end - first), 0.0);
        return;
    }
    for (std::size_t s = first; s < end; ++s) {
        const Vec3<double> c{spheres.x[s] - P.x, spheres.y[s] - P.y, spheres.z[s] - P.z};
        const Vec3<double> n = cross(c, D);
        missed_by[s - first] = dot(n, n) - ((spheres.r2[s] + 0x1p-40 * dot(c, c) + 0x1p-1000) * D2 + 0x1p-1000);
    }
}

void test_all(const Predicates& predicates, const SpheresAround& spheres, std::span<const Ray<double>> rays,
              std::span<std::uint32_t> met) {
    const std::size_t count = spheres.x.size();
    std::vector<std::optional<ProvenHit>> best(rays.size());
    const Silent silent;
    double missed_by[surfaces_together];
    for (std::size_t first = 0; first < count; first += surfaces_together) {
        const std::size_t end = std::min(count, first + surfaces_together);
        for (std::size_t r = 0; r < rays.size(); ++r) {
            find_missed(spheres, first, end, rays[r], missed_by);
            for (std::size_t s = first; s < end; ++s) {
                if (missed_by[s - first] > 0) continue;
                with_surface(predicates.store().surfaces, s,
                             [&](const auto& shape) { predicates.test(best[r], rays[r], shape, s, silent); });
            }
        }
    }
    std::transform(best.begin(), best.end(), met.begin(),
                   [](const auto& hit) { return hit ? static_cast<std::uint32_t>(hit->surface) : engine::no_surface; });
}

}  // namespace

std::vector<std::uint32_t> nearest_by_plain_loop(const Scene& scene, std::span<const Ray<double>> rays,
                                                 const Job& job) {
    const CertifiedSearch search(surfaces<double>(scene, 5), {}, {}, reach_of(rays), false);
    const SpheresAround spheres(search.predicates().store().surfaces);
    std::vector<std::uint32_t> met(rays.size());
    run_parallel(tbb::blocked_range<std::size_t>(0, rays.size(), rays_together), job, [&](const auto& range) {
        throw_if_stopped(job);
        test_all(search.predicates(), spheres, rays.subspan(range.begin(), range.size()),
                 std::span(met).subspan(range.begin(), range.size()));
        if (job.done) *job.done += static_cast<std::int64_t>(range.size());
    });
    return met;
}

}  // namespace glassbox
