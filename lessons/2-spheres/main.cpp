// Lesson 2: of all that a ray meets, the nearest is what you see. On the left the paper's two spheres in flat colours;
// on the right the same two from behind, in a room that is a sphere, too, with the eye inside it. There each has a
// pattern of tiles by its normal.
#include <array>
#include <cmath>
#include <picture.hpp>
#include <probe.hpp>
#include <sphere.hpp>
#include <viewing_plane.hpp>

using namespace glassbox;

/// 1 or 0.7 in turn, in tiles of a quarter of the normal's components.
double tile(const Vec3<double>& n) {
    return std::fmod(std::floor(4 * n.x) + std::floor(4 * n.y) + std::floor(4 * n.z), 2) == 0 ? 1 : 0.7;
}

int main(int argc, char** argv) {
    constexpr int width = 500, height = 500;
    const Parallel<double> paper{{{500, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {-1, 0, 0}};
    const Pinhole<double> inside = looking<double>({-40, 200, 230}, {90, 330, 330}, {0, 0, 1}, 50, width, height);

    const std::array<Sphere<double>, 3> spheres{{{{100, 350, 350}, 50}, {{50, 300, 300}, 20}, {{60, 300, 300}, 250}}};
    const std::array<Vec3<double>, 3> colors{{{0, 255, 0}, {255, 0, 0}, {110, 150, 255}}};

    Silent probe;
    Picture picture(2 * width, height);
    for (int i = 0; i < height; ++i) {
        for (int j = 0; j < width; ++j) {
            std::optional<Hit<double>> hit;
            const Ray<double> left = pixel_ray(paper, j, i);
            for (std::size_t k = 0; k < 2; ++k)  // without the room
                hit = nearest(hit, k, intersect(left, spheres[k], Textbook{}, probe));
            if (hit) picture.paint(j, i, colors[hit->surface]);

            hit.reset();
            const Ray<double> right = pixel_ray(inside, j, i);
            for (std::size_t k = 0; k < 3; ++k) hit = nearest(hit, k, intersect(right, spheres[k], Stable{}, probe));
            if (!hit) continue;
            const Vec3<double> n = normal(spheres[hit->surface], at(right, hit->t));
            picture.paint(width + j, i, tile(n) * colors[hit->surface]);
        }
    }
    return picture.write(argc > 1 ? argv[1] : "spheres.ppm");
}
