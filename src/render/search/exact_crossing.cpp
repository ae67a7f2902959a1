#include "render/search/exact_crossing.hpp"

#include <algorithm>
#include <cmath>

#include <probe.hpp>

#include "numerics/exact.hpp"
#include "render/search/far_point.hpp"
#include "render/search/surface_normal.hpp"

namespace glassbox {

namespace {

template <class Surface, class Rule>
std::optional<TrueT> crossing(const Ray<double>& ray, const Surface& surface, const Rule& rule) {
    const Silent silent;
    Crossing<Exact> exact = intersect(convert<Exact>(ray), convert<Exact>(surface), rule, silent);
    if (!surely(exact.met)) return {};
    return TrueT(std::move(exact.t));
}

Vec3<double> rounded_once(const Vec3<Exact>& a) {
    return {a.x.to_bounded().value, a.y.to_bounded().value, a.z.to_bounded().value};
}

Exact power_of_two(int n) { return Exact(std::ldexp(1.0, std::clamp(n, -1000, 1000))); }

/// An edge, in units that make its length ordinary.
Vec3<Exact> edge(const Vec3<double>& from, const Vec3<double>& to) {
    const Vec3<double> rounded = to - from;
    const int e = is_finite(rounded) ? exponent(rounded) : 1000;
    return power_of_two(-e) * (convert<Exact>(to) - convert<Exact>(from));
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

std::array<int, 3> exact_side_signs(const Ray<double>& ray, const Triangle<double>& triangle) {
    const auto [P, D] = convert<Exact>(ray);
    const Sides<Exact> exact = sides(D, seen_from(P, convert<Exact>(triangle)));
    return {exact.a.sign(), exact.b.sign(), exact.c.sign()};
}

std::optional<Vec3<double>> exact_normal(const Ray<double>& ray, const Sphere<double>& sphere, const SphereRule& rule) {
    const int e = std::ilogb(sphere.r);
    if (const auto seen = far_point(ray, sphere))
        return unit_normal(Sphere<double>{{}, 1}, std::ldexp(1.0, -e) * *seen);
    const std::optional<TrueT> t = exact_crossing(ray, sphere, rule);
    if (!t) return {};
    const Vec3<Exact> point = at(convert<Exact>(ray), t->exact()) - convert<Exact>(sphere.C);
    const Vec3<double> seen = rounded_once(power_of_two(-e) * point);
    return unit_normal(Sphere<double>{{}, 1}, seen);
}

std::optional<Vec3<double>> exact_normal(const Ray<double>&, const Triangle<double>& triangle, const TriangleRule&) {
    const auto& [A, B, C] = triangle;
    if (A == B || A == C) return {};
    const Vec3<double> n = rounded_once(cross(edge(A, B), edge(A, C)));
    if (n == Vec3<double>{}) return {};
    return unit_normal(Sphere<double>{{}, 1}, n);  // of length 1, whatever its size
}

}  // namespace glassbox
