#include "render/shoot.hpp"

#include "render/parallel.hpp"
#include "render/tracer.hpp"

namespace glassbox {

namespace {

struct CountHits {
    std::size_t hits = 0;

    template <class What, class... Values>
    void operator()(What, const Values&...) {}

    template <class Real>
    void operator()(told::Met, std::size_t, const Real&) {
        ++hits;
    }
};

}  // namespace

std::vector<Shot> shoot(const Scene& scene, const Options& options, std::span<const Ray<double>> rays, const Job& job) {
    std::vector<Shot> shots(rays.size());
    with_tracer(scene, options, [&]<class Real, class... Rules>(const Tracer<Real, Rules...>& tracer) {
        for_each_index(rays.size(), job, [&](std::size_t i) {
            const Ray<Real> ray = convert<Real>(rays[i]);
            if (!is_valid(rays[i])) return;
            CountHits count;
            const auto hit = tracer.trace(ray, count);
            shots[i] = hit ? Shot{Shot::Verdict::hit, hit->surface, hit->t, count.hits} : Shot{Shot::Verdict::miss};
        });
    });
    return shots;
}

}  // namespace glassbox
