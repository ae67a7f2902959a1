// Lesson 2: a ray meets spheres. Six parts, one for each step:
//
//   4 nearest      5 normal   6 chord
//   1 discriminant 2 roots    3 first_ahead
#include <array>
#include <cmath>
#include <intersect_sphere.hpp>
#include <picture.hpp>
#include <probe.hpp>
#include <viewing_plane.hpp>

using namespace glassbox;

constexpr int size = 250;  // each part, in pixels

const Vec3<double> black{0, 0, 0}, white{255, 255, 255}, orange{230, 120, 30}, blue{40, 90, 200};
const std::array<Vec3<double>, 3> colors{{{0, 255, 0}, {255, 0, 0}, {110, 150, 255}}};

/// The paper's two spheres, and a room about them.
const std::array<Sphere<double>, 3> spheres{{{{100, 350, 350}, 50}, {{50, 300, 300}, 20}, {{60, 300, 300}, 250}}};

/// 1 or 0.7 in turn, in tiles of a quarter of the normal's components.
double tile(const Vec3<double>& n) {
    return std::fmod(std::floor(4 * n.x) + std::floor(4 * n.y) + std::floor(4 * n.z), 2) == 0 ? 1 : 0.7;
}

/// What the ray meets first of the first `count` spheres.
std::optional<Hit<double>> first_hit(const Ray<double>& ray, std::size_t count) {
    Silent probe;
    std::optional<Hit<double>> hit;
    for (std::size_t k = 0; k < count; ++k) hit = nearest(hit, k, intersect(ray, spheres[k], Textbook{}, probe));
    return hit;
}

int main(int argc, char** argv) {
    // 1 to 3 look at the green sphere along -x, a pixel a unit: column j, row i is the ray through (y, z) = (225 + j,
    // 225 + i).
    const Parallel<double> at_green{{{500, 225, 225}, {0, 1, 0}, {0, 0, 1}}, {-1, 0, 0}};
    // 4 and 5 look from inside the room.
    const Pinhole<double> inside = looking<double>({-40, 200, 230}, {90, 330, 330}, {0, 0, 1}, 50, size, size);

    Picture picture(3 * size, 2 * size);
    picture.paint_part(0, 0, size, size, [&](int j, int i) {  // Δ: its sign, and its size in bands
        const double delta = discriminant(quadratic(pixel_ray(at_green, j, i), spheres[0]));
        const double band = std::fmod(std::floor(std::abs(delta) / 500), 2) == 0 ? 1 : 0.8;
        return delta > 0 ? band * orange : delta < 0 ? band * blue : white;
    });
    picture.paint_part(size, 0, size, size, [&](int j, int i) {  // t₁ − t₀, up to 100: how long the ray is inside
        const Quadratic<double> equation = quadratic(pixel_ray(at_green, j, i), spheres[0]);
        const double delta = discriminant(equation);
        if (!(delta >= 0)) return black;
        const auto [t0, t1] = roots(equation, std::sqrt(delta));
        const double grey = 2.5 * (t1 - t0);
        return Vec3<double>{grey, grey, grey};
    });
    picture.paint_part(2 * size, 0, size, size, [&](int j, int i) {  // t of the room's wall, from inside: rings of 10
        Silent probe;
        const Crossing<double> wall = intersect(pixel_ray(inside, j, i), spheres[2], Textbook{}, probe);
        // The plane is at distance 1, so t counts in lengths of D, which is nearly 1.
        return !wall.met ? black : std::fmod(std::floor(wall.t / 10), 2) == 0 ? blue : 0.8 * blue;
    });
    picture.paint_part(0, size, size, size, [&](int j, int i) {
        const auto hit = first_hit(pixel_ray(inside, j, i), 3);
        return hit ? colors[hit->surface] : black;
    });
    picture.paint_part(size, size, size, size, [&](int j, int i) {
        const Ray<double> ray = pixel_ray(inside, j, i);
        const auto hit = first_hit(ray, 3);
        return hit ? tile(normal(spheres[hit->surface], at(ray, hit->t))) * colors[hit->surface] : black;
    });
    picture.paint_part(2 * size, size, size, size, [&](int j, int i) {  // float, 400 radii away: textbook, and chord
        Silent probe;
        const bool is_upper = i >= size / 2;
        const Sphere<float> far{{0, 0, 0}, 0.1f};
        const float y = static_cast<float>(j - size / 2) / 500, z = static_cast<float>(i % (size / 2) - size / 4) / 500;
        const Ray<float> ray{{400, y, z}, {-1, 0, 0}};
        const bool met =
            is_upper ? intersect(ray, far, Textbook{}, probe).met : intersect(ray, far, Stable{}, probe).met;
        return met ? orange : black;
    });
    return picture.write(argc > 1 ? argv[1] : "spheres.ppm");
}
