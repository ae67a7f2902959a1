#include "render/shoot.hpp"

#include "render/parallel.hpp"
#include "render/search/with_search.hpp"

namespace glassbox {

namespace {

/// Counts the surfaces that a ray meets, and those that needed exact arithmetic.
struct CountHits {
    static constexpr bool only_verdicts = true;

    std::size_t hits = 0;
    std::size_t undecided = 0;

    template <class What, class... Values>
    void operator()(What, const Values&...) {
        if constexpr (std::is_same_v<What, told::Met>) ++hits;
        if constexpr (std::is_same_v<What, told::Undecided>) ++undecided;
    }
};

template <class Real, class... Rules>
Shot shot(const PlainSearch<Real, Rules...>& search, const Ray<double>& ray) {
    CountHits count;
    const auto hit = search.trace(convert<Real>(ray), count);
    if (!hit) return {.answer = Shot::Answer::miss};
    return {.answer = Shot::Answer::hit, .surface = hit->surface, .t = hit->t, .hits = count.hits};
}

/// The result by a certified search.
template <class Search>
Shot shot(const Search& search, const Ray<double>& ray) {
    CountHits count;
    const auto hit = search.trace_proven(ray, count);
    const bool by_filter = count.undecided == 0;
    if (!hit) return {.answer = Shot::Answer::miss, .by_filter = by_filter};
    const Bounded t = search.predicates().sharpened(ray, *hit);
    return {.answer = Shot::Answer::hit,
            .surface = hit->surface,
            .t = t.value,
            .hits = count.hits,
            .t_error = t.error,
            .by_filter = by_filter};
}

}  // namespace

std::vector<Shot> shoot(const Scene& scene, const Options& options, std::span<const Ray<double>> rays, const Job& job) {
    std::vector<Shot> shots(rays.size());
    with_search<CountHits>(scene, options, reach_of(rays), job, [&](const auto& search) {
        for_each_index(rays.size(), job, [&](std::size_t i) {
            if (is_valid(rays[i])) shots[i] = shot(search, rays[i]);
        });
    });
    return shots;
}

}  // namespace glassbox
