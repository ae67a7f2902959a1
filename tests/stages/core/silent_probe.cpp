// A renderer's inner loop with the probe that does nothing. CompareCode.cmake compiles it twice, with the core as it is
// and with a core that has no probes, and compares the machine code.
#include <intersect_sphere.hpp>
#include <levental_2014.hpp>
#include <moeller_trumbore.hpp>
#include <probe.hpp>
#include <shade_by_model.hpp>
#include <tolerance.hpp>

namespace glassbox {

template <class RootsRule, class TriangleRule>
Rgb seen(const Ray<double>& ray, const Sphere<double>* spheres, std::size_t n_spheres,
         const Triangle<double>* triangles, std::size_t n_triangles, const Vec3<double>* colors,
         const Light<double>& light, const Shading<double>& shading, const RootsRule& roots, const TriangleRule& rule) {
    Silent probe;
    std::optional<Hit<double>> hit;
    for (std::size_t k = 0; k < n_spheres; ++k) hit = nearest(hit, k, intersect(ray, spheres[k], roots, probe));
    for (std::size_t k = 0; k < n_triangles; ++k)
        hit = nearest(hit, n_spheres + k, intersect(ray, triangles[k], rule, probe));
    if (!hit) return {};
    const std::size_t k = hit->surface;
    const Vec3<double> n = k < n_spheres ? normal(spheres[k], at(ray, hit->t)) : normal(triangles[k - n_spheres]);
    return to_rgb(shade_by_model(n, -unit(ray.D), colors[k], light, shading, probe), shading.model);
}

#define INSTANTIATE(Roots, Rule)                                                                                    \
    template Rgb seen(const Ray<double>&, const Sphere<double>*, std::size_t, const Triangle<double>*, std::size_t, \
                      const Vec3<double>*, const Light<double>&, const Shading<double>&, const Roots&, const Rule&);
INSTANTIATE(Textbook, Tolerance)
INSTANTIATE(Stable, Pluecker)
INSTANTIATE(Levental2014, Pluecker)

}  // namespace glassbox
