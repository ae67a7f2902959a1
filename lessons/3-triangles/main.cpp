// Lesson 3: a tetrahedron joins the spheres: four triangles, each tested by its three side products.
#include <array>
#include <picture.hpp>
#include <probe.hpp>
#include <sphere.hpp>
#include <triangle.hpp>
#include <viewing_plane.hpp>

using namespace glassbox;

int main(int argc, char** argv) {
    constexpr int width = 500, height = 500;
    const Parallel<double> view{{{500, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {-1, 0, 0}};

    const std::array<Sphere<double>, 2> spheres{{{{100, 350, 350}, 50}, {{50, 300, 300}, 20}}};
    const Vec3<double> P{200, 350, 100}, Q{200, 400, 100}, R{200, 375, 150}, S{250, 375, 100};
    const std::array<Triangle<double>, 4> triangles{{{P, Q, R}, {P, Q, S}, {P, S, R}, {Q, R, S}}};
    // surfaces are numbered: the spheres, then the triangles
    const Vec3<double> green{0, 255, 0}, red{255, 0, 0}, grey{128, 128, 128};
    const std::array<Vec3<double>, 6> colors{green, red, grey, grey, grey, grey};

    Silent probe;
    Picture picture(width, height);
    for (int i = 0; i < height; ++i) {
        for (int j = 0; j < width; ++j) {
            const Ray<double> ray = pixel_ray(view, j, i);
            std::optional<Hit<double>> hit;
            for (std::size_t k = 0; k < spheres.size(); ++k)
                hit = nearest(hit, k, intersect(ray, spheres[k], Textbook{}, probe));
            for (std::size_t k = 0; k < triangles.size(); ++k)
                hit = nearest(hit, spheres.size() + k, intersect(ray, triangles[k], Pluecker{}, probe));
            if (hit) picture.paint(j, i, colors[hit->surface]);
        }
    }
    return picture.write(argc > 1 ? argv[1] : "triangles.ppm");
}
