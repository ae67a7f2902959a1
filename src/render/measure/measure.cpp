#include <cmath>
#include <compare>
#include <map>
#include <optional>
#include <utility>

#include "render/measure/filled_channels.hpp"
#include "render/measure/known_zeros.hpp"
#include "render/measure/measure_sides.hpp"
#include "render/measure/reference_search.hpp"
#include "render/render.hpp"
#include "render/trace_pixels.hpp"

namespace glassbox {

namespace {

PixelNumbers& numbers_of(PixelNumbers& probe) { return probe; }
PixelNumbers& numbers_of(WithTriangles& probe) { return probe.numbers; }

/// The distance between the starts of a pixel's rays in two views.
double drift(const View& one, const View& other, int x, int y, int height) {
    const auto [dx, dy, dz] = pixel_ray(one, x, y, height).P - pixel_ray(other, x, y, height).P;
    return std::hypot(dx, dy, dz);  // its squares neither overflow nor underflow
}

/// The union of the measurements' needs.
Needs needs_of(std::span<const Measurement* const> wanted) {
    Needs needs;
    for (const Measurement* measurement : wanted) {
        needs.truth |= measurement->needs.truth;
        if (measurement->needs.sides != OfSides::nothing) needs.sides = OfSides::all;
        needs.drift |= measurement->needs.drift;
        needs.all_hits |= measurement->needs.all_hits;
        needs.boxes |= measurement->needs.boxes;
    }
    return needs;
}

/// Measures what a probe hears of the search that the options name.
template <class Probe>
std::vector<std::vector<Channel>> measured_by_search(const Scene& scene, const Options& options, bool by_engine,
                                                     std::span<const Measurement* const> wanted, Job job) {
    const Needs needs = needs_of(wanted);
    // The engine's traversal to the nearest hit skips what lies behind it.
    const bool count_hits = needs.all_hits && by_engine;
    if (!job.engine && (needs.truth || by_engine)) job.engine = build_engine(scene, options.stage, job.threads);
    const View rebuilt = rebuilt_view(scene, turns_of(options));
    const View accumulated = accumulated_view(scene, turns_of(options));
    std::optional<ReferenceSearch> reference;
    if (needs.truth || count_hits) reference.emplace(job.engine);

    std::optional<KnownZeros> known_zeros;
    if (needs.sides != OfSides::nothing) known_zeros.emplace(scene, options);

    FilledChannels channels(scene, wanted);
    trace_pixels<Probe>(scene, options, job, [&](int x, int y, const Ray<double>& ray, Rgb, Probe& probe) {
        PixelNumbers& numbers = numbers_of(probe);
        if (needs.drift) numbers.drift = drift(rebuilt, accumulated, x, y, scene.height);
        if (is_proven(options.scalar)) numbers.undecided = static_cast<double>(numbers.exact_tests);
        if (count_hits) numbers.hits = static_cast<double>(reference->hits(ray).met.size());
        if (needs.truth) reference->compare(ray, options.scalar, numbers);
        if (known_zeros) known_zeros->take_into(ray, numbers.triangles);
        channels.fill({x, y}, numbers, {options, scene.shading.model, by_engine, is_valid(ray)});
    });
    return channels.filled(options);
}

/// What measurements that are made at once, in one way, ask for. The slowest come first.
struct Asked {
    bool only_count = false;
    OfSides sides = OfSides::nothing;

    friend auto operator<=>(const Asked&, const Asked&) = default;
};

/// In the plain loop every surface is tested: so what is asked of side products alone needs no search, and the number
/// of tests is known. By the engine all is found by the same search.
std::vector<std::vector<Channel>> measured(const Asked& asked, const Scene& scene, const Options& options,
                                           bool by_engine, std::span<const Measurement* const> wanted, const Job& job) {
    if (asked.only_count) return counted_tests(scene, options, wanted, job);
    if (asked.sides != OfSides::nothing) return measured_by_sides(scene, options, asked.sides, wanted, job);
    return needs_of(wanted).sides != OfSides::nothing
               ? measured_by_search<WithTriangles>(scene, options, by_engine, wanted, job)
               : measured_by_search<PixelNumbers>(scene, options, by_engine, wanted, job);
}

}  // namespace

std::vector<std::vector<Channel>> measure(const Scene& scene, const Options& given,
                                          std::span<const Measurement* const> wanted, const Job& job) {
    Options options = given;
    if (needs_of(wanted).boxes && options.engine == EngineChoice::automatic) options.engine = EngineChoice::fast;
    const bool by_engine = uses_engine(scene, options, false);

    std::map<Asked, std::vector<std::size_t>> groups;
    for (std::size_t m = 0; m < wanted.size(); ++m) {
        const Needs& needs = wanted[m]->needs;
        groups[by_engine ? Asked{} : Asked{needs.only_count, needs.sides}].push_back(m);
    }

    std::vector<std::vector<Channel>> result(wanted.size());
    Job one_job = job;
    for (const auto& [asked, numbers] : groups) {
        std::vector<const Measurement*> these;
        for (const std::size_t m : numbers) these.push_back(wanted[m]);
        auto channels = measured(asked, scene, options, by_engine, these, one_job);
        for (std::size_t i = 0; i < numbers.size(); ++i) result[numbers[i]] = std::move(channels[i]);
        one_job.done = nullptr;  // a pixel counts once
    }
    return result;
}

}  // namespace glassbox
