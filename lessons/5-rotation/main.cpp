// Lesson 5: turning. Six pictures in a row, each turned by 10 more degrees about z (the paper's key d): the scene and
// its light stay, the viewing plane and the direction of its rays go round the world's origin together.
#include <array>
#include <intersect_sphere.hpp>
#include <intersect_triangle.hpp>
#include <picture.hpp>
#include <probe.hpp>
#include <shade.hpp>
#include <turn.hpp>

using namespace glassbox;

int main(int argc, char** argv) {
    constexpr int frames = 6, width = 250, height = 250;  // every second pixel of the paper's
    const Parallel<double> straight{{{500, 0, 0}, {0, 2, 0}, {0, 0, 2}}, {-1, 0, 0}};
    const Light<double> light = directional_light<double>({1000, 250, 250}, 1);
    const Shading<double> shading{ShadingModel::blinn_phong, 0.2, 1, 0.2, 15, {255, 102, 102}, {255, 255, 255}};

    const std::array<Sphere<double>, 2> spheres{{{{100, 350, 350}, 50}, {{50, 300, 300}, 20}}};
    const Vec3<double> P{200, 350, 100}, Q{200, 400, 100}, R{200, 375, 150}, S{250, 375, 100};
    const std::array<Triangle<double>, 4> triangles{{{P, Q, R}, {P, Q, S}, {P, S, R}, {Q, R, S}}};
    const Vec3<double> green{0, 255, 0}, red{255, 0, 0}, grey{128, 128, 128};
    const std::array<Vec3<double>, 6> colors{green, red, grey, grey, grey, grey};

    Silent probe;
    Picture picture(frames * width, height);
    for (int frame = 0; frame < frames; ++frame) {
        const Turn<double> turn{Axis::z, 10.0 * frame};
        const Parallel<double> view = turned(straight, rotation(turn), {0, 0, 0});
        for (int i = 0; i < height; ++i) {
            for (int j = 0; j < width; ++j) {
                const Ray<double> ray = pixel_ray(view, j, i);
                std::optional<Hit<double>> hit;
                for (std::size_t k = 0; k < spheres.size(); ++k)
                    hit = nearest(hit, k, intersect(ray, spheres[k], Stable{}, probe));
                for (std::size_t k = 0; k < triangles.size(); ++k)
                    hit = nearest(hit, spheres.size() + k, intersect(ray, triangles[k], Pluecker{}, probe));
                if (!hit) continue;
                const std::size_t k = hit->surface;
                const Vec3<double> n =
                    k < spheres.size() ? normal(spheres[k], at(ray, hit->t)) : normal(triangles[k - spheres.size()]);
                const Terms<double> terms = shade(n, -unit(ray.D), colors[k], light, shading, probe);
                picture.paint(frame * width + j, i, to_rgb(terms));
            }
        }
    }
    return picture.write(argc > 1 ? argv[1] : "rotation.ppm");
}
