// Lesson 2: two spheres in flat colours. Of all that a ray meets, the nearest is what you see.
#include <array>
#include <picture.hpp>
#include <probe.hpp>
#include <sphere.hpp>
#include <viewing_plane.hpp>

using namespace glassbox;

int main(int argc, char** argv) {
    constexpr int width = 500, height = 500;
    const Parallel<double> view{{{500, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {-1, 0, 0}};

    const std::array<Sphere<double>, 2> spheres{{{{100, 350, 350}, 50}, {{50, 300, 300}, 20}}};
    const std::array<Vec3<double>, 2> colors{{{0, 255, 0}, {255, 0, 0}}};

    Silent probe;
    Picture picture(width, height);
    for (int i = 0; i < height; ++i) {
        for (int j = 0; j < width; ++j) {
            const Ray<double> ray = pixel_ray(view, j, i);
            std::optional<Hit<double>> hit;
            for (std::size_t k = 0; k < spheres.size(); ++k)
                hit = nearest(hit, k, intersect(ray, spheres[k], Textbook{}, probe));
            if (hit) picture.paint(j, i, colors[hit->surface]);
        }
    }
    return picture.write(argc > 1 ? argv[1] : "spheres.ppm");
}
