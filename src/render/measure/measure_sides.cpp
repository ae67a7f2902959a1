#include "render/measure/measure_sides.hpp"

#include <algorithm>

#include "render/measure/deciding_triangles.hpp"
#include "render/measure/filled_channels.hpp"
#include "render/measure/known_zeros.hpp"
#include "render/parallel.hpp"
#include "render/search/surfaces.hpp"
#include "render/view.hpp"

namespace glassbox {

namespace {

/// A search that proves its answers tests nothing where there is no ray; plain scalars compute what they are given.
bool is_tested(const Ray<double>& ray, const Options& options) { return !is_proven(options.scalar) || is_valid(ray); }

/// Tests the rays of all pixels, in the scalar Real, against the triangles that matter, and calls `keep(pixel, ray,
/// numbers)` for each.
template <class Real, class Keep>
void test_triangles(const Scene& scene, const Options& options, OfSides asked, const Job& job, const Keep& keep) {
    const Surfaces<Real> all = surfaces<Real>(scene, options.stage);
    std::vector<Triangle<double>> triangles;  // the scalar's numbers come from doubles: a double holds each of them
    std::ranges::transform(all.triangles, std::back_inserter(triangles),
                           [](const Triangle<Real>& triangle) { return convert<double>(triangle); });
    const DecidingTriangles deciding(triangles, options.scalar, asked);
    const Chosen<TriangleRule> rule{options.triangle_rule};
    const View seen = view(scene, options);
    for_each_block(scene.width, scene.height, job, [&](const auto& columns, const auto& rows) {
        const auto take = [&](int x, int y, std::span<const std::uint32_t> numbers) {
            throw_if_stopped(job);
            const Ray<double> ray = pixel_ray(seen, x, y, scene.height);
            WithTriangles probe;
            probe.numbers.triangles.asked = asked;
            if (is_tested(ray, options))
                for (const std::uint32_t number : numbers)
                    intersect(convert<Real>(ray), all.triangles[number], rule, probe);
            keep(Pixel{x, y}, ray, probe.numbers);
        };
        deciding.for_each_pixel(seen, scene.height, {columns.begin(), columns.end(), rows.begin(), rows.end()}, take);
        if (job.done) *job.done += static_cast<std::int64_t>(rows.size() * columns.size());
    });
}

template <class Keep>
void test_triangles_in(Scalar scalar, const Scene& scene, const Options& options, OfSides asked, const Job& job,
                       const Keep& keep) {
    if (scalar == Scalar::float_) return test_triangles<float>(scene, options, asked, job, keep);
    if (scalar == Scalar::long_double) return test_triangles<long double>(scene, options, asked, job, keep);
    return test_triangles<double>(scene, options, asked, job, keep);
}

}  // namespace

std::vector<std::vector<Channel>> measured_by_sides(const Scene& scene, const Options& options, OfSides asked,
                                                    std::span<const Measurement* const> wanted, const Job& job) {
    const KnownZeros known_zeros(scene, options);
    FilledChannels channels(scene, wanted);
    const auto keep = [&](Pixel pixel, const Ray<double>& ray, PixelNumbers& numbers) {
        known_zeros.take_into(ray, numbers.triangles);
        channels.fill(pixel, numbers, {options, scene.shading.model, false, is_valid(ray)});
    };
    test_triangles_in(options.scalar, scene, options, asked, job, keep);
    return channels.filled(options);
}

std::vector<std::vector<Channel>> counted_tests(const Scene& scene, const Options& options,
                                                std::span<const Measurement* const> wanted, const Job& job) {
    const auto [spheres, triangles] = count_surfaces(scene, options.stage);
    const auto all = static_cast<double>(spheres + triangles);
    const View seen = view(scene, options);
    FilledChannels channels(scene, wanted);
    for_each_pixel(scene.width, scene.height, job, [&](int x, int y) {
        const Ray<double> ray = pixel_ray(seen, x, y, scene.height);
        PixelNumbers numbers;
        if (is_tested(ray, options)) numbers.tests = all;
        channels.fill({x, y}, numbers, {options, scene.shading.model, false, is_valid(ray)});
    });
    return channels.filled(options);
}

}  // namespace glassbox
