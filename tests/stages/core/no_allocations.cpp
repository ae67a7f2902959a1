// A million rays through all five stages, and not one allocation.
#include <doctest.h>

#include <array>
#include <intersect_sphere.hpp>
#include <moeller_trumbore.hpp>
#include <new>
#include <probe.hpp>
#include <shade_by_model.hpp>
#include <tolerance.hpp>
#include <turn.hpp>

extern long allocations;  // counted_new.cpp

using namespace glassbox;

TEST_CASE("a million rays allocate nothing") {
    const Parallel<double> straight{{{500, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}}, {-1, 0, 0}};
    const Parallel<double> view = turned(straight, rotation(Turn<double>{Axis::z, 10}), {0, 0, 0});
    const Light<double> light = directional_light<double>({1000, 250, 250}, 1);
    const Shading<double> shading{ShadingModel::blinn_phong, 0.2, 1, 0.2, 15, {255, 102, 102}, {255, 255, 255}};
    const std::array<Sphere<double>, 2> spheres{{{{100, 350, 350}, 50}, {{50, 300, 300}, 20}}};
    const Triangle<double> triangle{{200, 350, 100}, {200, 400, 100}, {200, 375, 150}};

    Silent probe;
    long hits = 0, lit = 0;
    const long before = allocations;
    for (int i = 0; i < 1000; ++i) {
        for (int j = 0; j < 1000; ++j) {
            const Ray<double> ray = pixel_ray(view, j, i);
            std::optional<Hit<double>> hit;
            for (std::size_t k = 0; k < 2; ++k) hit = nearest(hit, k, intersect(ray, spheres[k], Stable{}, probe));
            hit = nearest(hit, 2, intersect(ray, triangle, Pluecker{}, probe));
            if (!hit) continue;
            ++hits;
            const Vec3<double> n = hit->surface < 2 ? normal(spheres[hit->surface], at(ray, hit->t)) : normal(triangle);
            lit +=
                to_rgb(shade_by_model(n, -unit(ray.D), {128, 128, 128}, light, shading, probe), shading.model).red > 0;
        }
    }
    const long during = allocations - before;
    CHECK(during == 0);
    // half a unit a pixel: the green sphere alone covers pi 100^2 = 31416 of them
    CHECK(hits > 31000);
    CHECK(lit == hits);
}

TEST_CASE("and an allocation would have been counted") {
    const long before = allocations;
    ::operator delete(::operator new(1));
    CHECK(allocations == before + 1);
}
