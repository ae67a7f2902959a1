#include "render/measure/known_zeros.hpp"

#include <algorithm>

#include "render/search/exact_crossing.hpp"
#include "render/search/surfaces.hpp"

namespace glassbox {

namespace {

template <class Real>
int sign_of(Real number) {
    return (number > 0) - (number < 0);
}

/// Whether exact arithmetic finds the signs that the scalar computed.
template <class Real>
bool signs_are_right(const Ray<Real>& ray, const Triangle<Real>& triangle, const Triangle<Real>& seen) {
    const Sides<Real> s = sides(ray.D, seen);
    // The scalar's numbers come from doubles: a double holds each of them.
    const std::array<int, 3> exact = exact_side_signs(convert<double>(ray), convert<double>(triangle));
    return exact == std::array{sign_of(s.a), sign_of(s.b), sign_of(s.c)};
}

template <class Real>
bool are_known_in(const Ray<double>& given, std::span<const Triangle<double>> triangles,
                  std::span<const Triangle<long double>> zeros) {
    const Ray<Real> ray = convert<Real>(given);
    return std::ranges::all_of(triangles, [&](const Triangle<double>& each) {
        const Triangle<Real> triangle = convert<Real>(each);
        const Triangle<Real> seen = seen_from(ray.P, triangle);
        const auto wide = convert<long double>(seen);
        const bool asked = std::ranges::any_of(
            zeros, [&](const auto& zero) { return zero.A == wide.A && zero.B == wide.B && zero.C == wide.C; });
        return !asked || signs_are_right(ray, triangle, seen);
    });
}

}  // namespace

KnownZeros::KnownZeros(const Scene& scene, const Options& options)
    : triangles_(surfaces<double>(scene, options.stage).triangles), scalar_(options.scalar) {}

bool KnownZeros::are_known(const Ray<double>& ray, std::span<const Triangle<long double>> seen) const {
    if (scalar_ == Scalar::float_) return are_known_in<float>(ray, triangles_, seen);
    if (scalar_ == Scalar::long_double) return are_known_in<long double>(ray, triangles_, seen);
    return are_known_in<double>(ray, triangles_, seen);
}

}  // namespace glassbox
