// Lesson 4: light. Each hit gets its normal, and the three terms of the paper's model: its final picture.
#include <array>
#include <levental_2014.hpp>
#include <picture.hpp>
#include <probe.hpp>
#include <shading.hpp>
#include <sphere.hpp>
#include <triangle.hpp>
#include <viewing_plane.hpp>

using namespace glassbox;

int main(int argc, char** argv) {
    constexpr int width = 500, height = 500;
    const Parallel<double> view{{{500, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {-1, 0, 0}};
    const Light<double> light = directional_light<double>({1000, 250, 250}, 1);
    const Shading<double> shading{ShadingModel::levental_2014, 0.2, 1, 0.2, 15, {255, 102, 102}, {255, 255, 255}};

    const std::array<Sphere<double>, 2> spheres{{{{100, 350, 350}, 50}, {{50, 300, 300}, 20}}};
    const Vec3<double> P{200, 350, 100}, Q{200, 400, 100}, R{200, 375, 150}, S{250, 375, 100};
    const std::array<Triangle<double>, 4> triangles{{{P, Q, R}, {P, Q, S}, {P, S, R}, {Q, R, S}}};
    const Vec3<double> green{0, 255, 0}, red{255, 0, 0}, grey{128, 128, 128};
    const std::array<Vec3<double>, 6> colors{green, red, grey, grey, grey, grey};

    Silent probe;
    Picture picture(width, height);
    for (int i = 0; i < height; ++i) {
        for (int j = 0; j < width; ++j) {
            const bool border = i == 0 || j == 0 || i == height - 1 || j == width - 1;
            if (border) picture.paint(j, i, red);
            const Ray<double> ray = pixel_ray(view, j, i);
            std::optional<Hit<double>> hit;
            for (std::size_t k = 0; k < spheres.size(); ++k)
                hit = nearest(hit, k, intersect(ray, spheres[k], Levental2014{}, probe));
            for (std::size_t k = 0; k < triangles.size(); ++k)
                hit = nearest(hit, spheres.size() + k, intersect(ray, triangles[k], Pluecker{}, probe));
            if (!hit) continue;
            const std::size_t k = hit->surface;
            const Vec3<double> n =
                k < spheres.size() ? normal(spheres[k], at(ray, hit->t)) : normal(triangles[k - spheres.size()]);
            const Vec3<double> r = -unit(ray.D);  // towards the viewer
            picture.paint(j, i, to_rgb(shade(n, r, colors[k], light, shading, probe), shading.model));
        }
    }
    return picture.write(argc > 1 ? argv[1] : "shading.ppm");
}
