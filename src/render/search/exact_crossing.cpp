#include "render/search/exact_crossing.hpp"

#include <probe.hpp>

#include "numerics/exact.hpp"

namespace glassbox {

namespace {

template <class Surface, class Rule>
std::optional<TrueT> crossing(const Ray<double>& ray, const Surface& surface, const Rule& rule) {
    const Silent silent;
    Crossing<Exact> exact = intersect(convert<Exact>(ray), convert<Exact>(surface), rule, silent);
    if (!surely(exact.met)) return {};
    return TrueT(std::move(exact.t));
}

}  // namespace

TrueT::TrueT(Exact t) : t_(std::make_shared<const Exact>(std::move(t))) {}

Bounded TrueT::to_bounded() const { return t_->to_bounded(); }

int compare(const TrueT& a, const TrueT& b) { return compare(*a.t_, *b.t_); }

std::optional<TrueT> exact_crossing(const Ray<double>& ray, const Sphere<double>& sphere, const SphereRule& rule) {
    return crossing(ray, sphere, Chosen{rule});
}

std::optional<TrueT> exact_crossing(const Ray<double>& ray, const Triangle<double>& triangle,
                                    const TriangleRule& rule) {
    return crossing(ray, triangle, Chosen{rule});
}

}  // namespace glassbox
