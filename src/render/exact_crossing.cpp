#include "render/exact_crossing.hpp"

#include <probe.hpp>

namespace glassbox {

namespace {

template <class Surface, class Rule>
std::optional<Exact> crossing(const Ray<double>& ray, const Surface& surface, const Rule& rule) {
    const Silent silent;
    Crossing<Exact> exact = intersect(convert<Exact>(ray), convert<Exact>(surface), rule, silent);
    if (!surely(exact.met)) return {};
    return std::move(exact.t);
}

}  // namespace

std::optional<Exact> exact_crossing(const Ray<double>& ray, const Sphere<double>& sphere, const Textbook& roots) {
    return crossing(ray, sphere, roots);
}

std::optional<Exact> exact_crossing(const Ray<double>& ray, const Sphere<double>& sphere, const Stable& roots) {
    return crossing(ray, sphere, roots);
}

std::optional<Exact> exact_crossing(const Ray<double>& ray, const Sphere<double>& sphere, const Levental2014& roots) {
    return crossing(ray, sphere, roots);
}

std::optional<Exact> exact_crossing(const Ray<double>& ray, const Triangle<double>& triangle, const Pluecker& test) {
    return crossing(ray, triangle, test);
}

std::optional<Exact> exact_crossing(const Ray<double>& ray, const Triangle<double>& triangle, const Tolerance& test) {
    return crossing(ray, triangle, test);
}

std::optional<Exact> exact_crossing(const Ray<double>& ray, const Triangle<double>& triangle,
                                    const MoellerTrumbore& test) {
    return crossing(ray, triangle, test);
}

}  // namespace glassbox
