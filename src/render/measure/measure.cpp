#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

#include "render/measure/known_zeros.hpp"
#include "render/measure/reference_search.hpp"
#include "render/measure/why_no_value.hpp"
#include "render/render.hpp"
#include "render/trace_pixels.hpp"

namespace glassbox {

namespace {

std::vector<Channel> empty_channels(const Measurement& measurement, int width, int height) {
    const std::size_t pixels = pixel_count(width, height);
    std::vector<Channel> channels;
    for (const std::string_view name : measurement.channels())
        channels.push_back({std::string(name), width, height, std::vector<double>(pixels, no_value)});
    return channels;
}

PixelNumbers& numbers_of(PixelNumbers& probe) { return probe; }
PixelNumbers& numbers_of(WithTriangles& probe) { return probe.numbers; }

/// The distance between the starts of a pixel's rays in two views.
double drift(const View& one, const View& other, int x, int y, int height) {
    const auto [dx, dy, dz] = pixel_ray(one, x, y, height).P - pixel_ray(other, x, y, height).P;
    return std::hypot(dx, dy, dz);  // its squares neither overflow nor underflow
}

/// The reason nearest to a value, of all pixels' reasons so far. Several threads add reasons.
class NearestReason {
public:
    void consider(WhyNoValue why) {
        WhyNoValue last = last_.load(std::memory_order_relaxed);
        while (last < why && !last_.compare_exchange_weak(last, why, std::memory_order_relaxed)) {
        }
    }
    WhyNoValue get() const { return last_; }

private:
    std::atomic<WhyNoValue> last_ = WhyNoValue::has_one;
};

bool has_value(const Channel& channel) {
    return !std::ranges::all_of(channel.values, [](double value) { return std::isnan(value); });
}

/// The union of the measurements' needs.
Needs needs_of(std::span<const Measurement* const> wanted) {
    Needs needs;
    for (const Measurement* measurement : wanted) {
        needs.truth |= measurement->needs.truth;
        needs.triangles |= measurement->needs.triangles;
        needs.drift |= measurement->needs.drift;
        needs.all_hits |= measurement->needs.all_hits;
        needs.boxes |= measurement->needs.boxes;
    }
    return needs;
}

/// Measures with the cheapest sufficient probe.
template <class Probe>
std::vector<std::vector<Channel>> measured_by(const Scene& scene, Options options,
                                              std::span<const Measurement* const> wanted, Job job) {
    const Needs needs = needs_of(wanted);
    if (needs.boxes && options.engine == EngineChoice::automatic) options.engine = EngineChoice::fast;
    // The engine's traversal to the nearest hit skips what lies behind it.
    const bool by_engine = uses_engine(scene, options, false);
    const bool count_hits = needs.all_hits && by_engine;
    if (!job.engine && (needs.truth || by_engine)) job.engine = build_engine(scene, options.stage, job.threads);
    const View rebuilt = rebuilt_view(scene, turns_of(options));
    const View accumulated = accumulated_view(scene, turns_of(options));
    std::optional<ReferenceSearch> reference;
    if (needs.truth || count_hits) reference.emplace(job.engine);

    std::optional<KnownZeros> known_zeros;
    if (needs.triangles) known_zeros.emplace(scene, options);

    std::vector<std::vector<Channel>> result;
    for (const Measurement* measurement : wanted)
        result.push_back(empty_channels(*measurement, scene.width, scene.height));

    std::vector<NearestReason> reasons(wanted.size());
    trace_pixels<Probe>(scene, options, job, [&](int x, int y, const Ray<double>& ray, Rgb, Probe& probe) {
        PixelNumbers& numbers = numbers_of(probe);
        if (needs.drift) numbers.drift = drift(rebuilt, accumulated, x, y, scene.height);
        if (is_proven(options.scalar)) numbers.undecided = static_cast<double>(numbers.exact_tests);
        if (count_hits) numbers.hits = static_cast<double>(reference->hits(ray).met.size());
        if (needs.truth) reference->compare(ray, options.scalar, numbers);
        TriangleNumbers& triangles = numbers.triangles;
        if (known_zeros && !triangles.zeros.empty() && known_zeros->are_known(ray, triangles.zeros))
            triangles.know_zeros();
        const std::size_t pixel = index_of({x, y}, scene.width);
        for (std::size_t m = 0; m < wanted.size(); ++m) {
            reasons[m].consider(
                why_no_value(*wanted[m], numbers, {options, scene.shading.model, by_engine, is_valid(ray)}));
            const std::array<double, 3> values = wanted[m]->read(numbers);
            for (std::size_t p = 0; p < result[m].size(); ++p) result[m][p].values[pixel] = values[p];
        }
    });
    for (std::size_t m = 0; m < wanted.size(); ++m)
        for (Channel& channel : result[m])
            if (!has_value(channel)) channel.why_no_value = reason_text(reasons[m].get(), *wanted[m], options);
    return result;
}

}  // namespace

std::vector<std::vector<Channel>> measure(const Scene& scene, const Options& options,
                                          std::span<const Measurement* const> wanted, const Job& job) {
    return needs_of(wanted).triangles ? measured_by<WithTriangles>(scene, options, wanted, job)
                                      : measured_by<PixelNumbers>(scene, options, wanted, job);
}

}  // namespace glassbox
