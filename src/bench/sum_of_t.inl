// The body of the functions of bare_numbers.hpp: included by files that are compiled with the headers as they are, and
// by one that is compiled with headers without probes.
#include <intersect_sphere.hpp>
#include <intersect_triangle.hpp>
#include <probe.hpp>

#include "render/search/plain_search.hpp"

namespace glassbox {
namespace {

/// A separate function with all its callees inlined: neither its surroundings nor the compiler's guess of the size of a
/// probe not yet inlined changes how it is compiled.
template <class Probe>
[[gnu::noinline, gnu::flatten]] double t_of_nearest(const PlainSearch<double, Stable, Pluecker>& search,
                                                    const Ray<double>& ray, Probe& probe) {
    const auto hit = search.trace(ray, probe);
    return hit ? hit->t : 0;
}

template <class Probe>
double sum_of_t(const BareNumbers& numbers, Probe& probe) {
    const auto& [spheres, triangles, rays] = numbers;
    const auto vec = [](std::span<const double> n) { return Vec3<double>{n[0], n[1], n[2]}; };
    PlainSearch<double, Stable, Pluecker> search{};
    for (auto s = spheres; !s.empty(); s = s.subspan(4)) search.surfaces.spheres.push_back({vec(s), s[3]});
    for (auto t = triangles; !t.empty(); t = t.subspan(9))
        search.surfaces.triangles.push_back({vec(t), vec(t.subspan(3)), vec(t.subspan(6))});
    double sum = 0;
    for (auto r = rays; !r.empty(); r = r.subspan(6)) sum += t_of_nearest(search, {vec(r), vec(r.subspan(3))}, probe);
    return sum;
}

}  // namespace
}  // namespace glassbox
