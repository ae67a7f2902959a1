#include "library/certified_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "render/search/fast_search.hpp"

namespace glassbox {

namespace {

/// Keeps which surfaces are met.
struct MetSurfaces {
    static constexpr bool only_verdicts = true;

    std::vector<std::size_t> surfaces;

    template <class What, class... Values>
    void operator()(What, const Values&...) {}

    template <class Real>
    void operator()(told::Met, std::size_t surface, const Real&) {
        surfaces.push_back(surface);
    }
};

void expect(bool holds, const char* what, std::size_t number, const char* must) {
    if (!holds) throw std::invalid_argument(std::string(what) + " " + std::to_string(number) + " must have " + must);
}

void expect_valid(const Ray<double>& ray) {
    if (!is_valid(ray)) throw std::invalid_argument("a ray must have finite numbers and a direction that is not 0");
}

FastSearch search(const std::shared_ptr<const engine::Engine>& engine) { return {engine, Stable{}, Pluecker{}}; }

CertifiedHit to_hit(const FastSearch& search, const Ray<double>& ray, const ProvenHit& hit) {
    const Bounded t = search.predicates().sharpened(ray, hit);
    return {hit.surface, t.value, t.error};
}

/// Does the ray meet `one` before the `other`?
bool is_before(const FastSearch& search, const Ray<double>& ray, const CertifiedHit& one, const CertifiedHit& other) {
    const Bounded t{one.t, one.t_error}, other_t{other.t, other.t_error};
    if (surely(t < other_t)) return true;
    if (surely(t > other_t)) return false;
    const int order =
        compare(*search.predicates().true_t(ray, one.surface), *search.predicates().true_t(ray, other.surface));
    return order != 0 ? order < 0 : one.surface > other.surface;
}

}  // namespace

CertifiedScene::CertifiedScene(std::vector<Sphere<double>> spheres, std::span<const Triangle<double>> triangles,
                               int threads) {
    for (std::size_t i = 0; i < spheres.size(); ++i)
        expect(is_finite(spheres[i].C) && std::isfinite(spheres[i].r) && spheres[i].r > 0, "sphere", i,
               "finite numbers and a radius above 0");
    for (std::size_t i = 0; i < triangles.size(); ++i)
        expect(is_finite(triangles[i].A) && is_finite(triangles[i].B) && is_finite(triangles[i].C), "triangle", i,
               "finite coordinates");
    engine_ = std::make_shared<const engine::Engine>(std::move(spheres), triangles, threads);
}

std::size_t CertifiedScene::size() const { return engine_->size(); }

std::optional<CertifiedHit> CertifiedScene::first_hit(const Ray<double>& ray) const {
    expect_valid(ray);
    const FastSearch fast = search(engine_);
    const Silent silent;
    const std::optional<ProvenHit> hit = fast.trace_proven(ray, silent);
    return hit ? std::optional(to_hit(fast, ray, *hit)) : std::nullopt;
}

std::vector<CertifiedHit> CertifiedScene::all_hits(const Ray<double>& ray) const {
    expect_valid(ray);
    const FastSearch fast = search(engine_);
    MetSurfaces met;
    fast.trace_proven(ray, met);
    std::vector<CertifiedHit> hits;
    for (const std::size_t surface : met.surfaces) {
        const double t = fast.predicates().t_of(ray, surface);
        hits.push_back(to_hit(fast, ray, {surface, {t, std::numeric_limits<double>::infinity()}, t, t}));
    }
    std::ranges::sort(hits, [&](const CertifiedHit& a, const CertifiedHit& b) { return is_before(fast, ray, a, b); });
    return hits;
}

}  // namespace glassbox
