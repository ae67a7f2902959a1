// Everything in the core, for the three built-in scalars. Compiled without exceptions and run-time types;
// CheckCore.cmake checks its headers and symbols.
#include <bounded.hpp>
#include <crossing.hpp>
#include <floating_point.hpp>
#include <intersect_sphere.hpp>
#include <kleene.hpp>
#include <levental_2014.hpp>
#include <light.hpp>
#include <magnitude.hpp>
#include <moeller_trumbore.hpp>
#include <pluecker.hpp>
#include <probe.hpp>
#include <ray.hpp>
#include <ray_color.hpp>
#include <rgb.hpp>
#include <shade_by_model.hpp>
#include <tolerance.hpp>
#include <truth.hpp>
#include <turn.hpp>
#include <vec3.hpp>
#include <viewing_plane.hpp>

#include <array>

namespace glassbox {

template <class Real>
Rgb everything(const Vec3<Real>& a, const Vec3<Real>& b, const Vec3<Real>& c, int width, int height) {
    Silent probe;
    const std::array<Turn<Real>, 2> turns{{{Axis::z, a.x}, {Axis::y, a.y}}};
    const Rotation<Real> R = rotation<Real>(turns);
    const Pinhole<Real> pinhole = turned(looking<Real>(a, b, c, 40, width, height), R, a);
    const Parallel<Real> parallel = turned(Parallel<Real>{pinhole.plane, unit(b - a)}, R, c);
    Vec3<Real> sum = cross(a, b) / length(c);
    for (const Ray<Real>& ray : {pixel_ray(pinhole, 1, 2), pixel_ray(parallel, 1, 2)}) {
        if (!is_valid(ray)) continue;
        const Sphere<Real> sphere{a, b.x};
        const Triangle<Real> triangle{a, b, c};
        std::optional<Hit<Real>> hit;
        hit = nearest(hit, 0, intersect(ray, sphere, Textbook{}, probe));
        hit = nearest(hit, 1, intersect(ray, sphere, Stable{}, probe));
        hit = nearest(hit, 2, intersect(ray, sphere, Levental2014{}, probe));
        hit = nearest(hit, 3, intersect(ray, triangle, Pluecker{}, probe));
        const Silent silent;
        const Crossing<Bounded> bounded = intersect(convert<Bounded>(convert<double>(ray)),
                                                    convert<Bounded>(convert<double>(triangle)), Pluecker{}, silent);
        if (surely(bounded.met)) sum = static_cast<Real>(bounded.t.error) * sum;
        sum = static_cast<Real>(dot(convert<Magnitude>(ray.P), convert<Magnitude>(ray.D)).size) * sum;
        hit = nearest(hit, 4, intersect(ray, triangle, Tolerance{}, probe));
        hit = nearest(hit, 5, intersect(ray, triangle, MoellerTrumbore{}, probe));
        if (!hit) continue;
        const Vec3<Real> n = hit->surface < 3 ? normal(sphere, at(ray, hit->t)) : normal(triangle);
        const Light<Real> light = directional_light(c, a.z);
        for (const ShadingModel model : {ShadingModel::phong, ShadingModel::blinn_phong, ShadingModel::levental_2014}) {
            const Shading<Real> shading{model, a.x, a.y, a.z, 15, a, b};
            sum = sum + to_vec3<Real>(to_rgb(shade_by_model(n, -unit(ray.D), c, light, shading, probe), model));
        }
        sum = sum + convert<Real>(convert<double>(ray)).P + ray_color(ray, width, height);
    }
    return truncated(sum) + rounded(sum);
}

template Rgb everything(const Vec3<float>&, const Vec3<float>&, const Vec3<float>&, int, int);
template Rgb everything(const Vec3<double>&, const Vec3<double>&, const Vec3<double>&, int, int);
template Rgb everything(const Vec3<long double>&, const Vec3<long double>&, const Vec3<long double>&, int, int);

}  // namespace glassbox
