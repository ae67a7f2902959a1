// Lesson 5: turning. Eight parts, one for each step:
//
//   7 the paper's scene, by 0, 10, 20, 30 degrees    8 a pinhole view, by 0, 60 degrees
//   1 R * v   2 R * S   3 one turn   4 many turns   5 a point, about a pivot   6 planes
#include <array>
#include <cmath>
#include <intersect_sphere.hpp>
#include <intersect_triangle.hpp>
#include <picture.hpp>
#include <probe.hpp>
#include <shade.hpp>
#include <turn.hpp>
#include <vector>

using namespace glassbox;

constexpr int size = 250;  // each part's, or frame's, in pixels

const Vec3<double> black{0, 0, 0}, white{255, 255, 255}, orange{230, 120, 30}, blue{40, 90, 200};
const Vec3<double> x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

/// A house with the origin in its middle, drawn on the ground of a meadow.
Vec3<double> house(const Vec3<double>& v) {
    const Vec3<double> meadow{70, 110, 60}, wall{235, 215, 165}, door{90, 50, 30}, roof{190, 60, 40};
    if (v.x >= 10 && v.x <= 30 && v.y >= -60 && v.y <= -20) return door;
    if (std::abs(v.x) <= 40 && v.y >= -60 && v.y <= 20) return wall;
    if (std::abs(v.x) <= 70 - v.y && v.y > 20) return roof;
    return meadow;
}

/// A ball's colour where its normal is n: by n's largest component, as if a die were blown up. x red, y green, z blue;
/// dark where it is negative.
Vec3<double> die(const Vec3<double>& n) {
    const double a = std::abs(n.x), b = std::abs(n.y), c = std::abs(n.z);
    if (a >= b && a >= c) return (n.x > 0 ? 1 : 0.4) * Vec3<double>{230, 60, 50};
    if (b >= c) return (n.y > 0 ? 1 : 0.4) * Vec3<double>{60, 190, 70};
    return (n.z > 0 ? 1 : 0.4) * Vec3<double>{80, 130, 255};
}

/// A part of `columns` times `columns` balls, numbered from 0 at the bottom left. Seen from the tip of x; y is to the
/// right, z is up. Ball k shows what the die has where the normal comes to when it is turned by `rotations(k)`.
template <class Rotations>
Vec3<double> balls(int j, int i, int columns, const Rotations& rotations) {
    const int cell = size / columns;
    const double radius = 0.46 * cell, right = (j % cell - cell / 2) / radius, up = (i % cell - cell / 2) / radius;
    const double rest = 1 - right * right - up * up;
    if (rest < 0) return black;
    const Rotation<double> R = rotations(i / cell * columns + j / cell);
    return die(R * Vec3<double>{std::sqrt(rest), right, up});
}

/// What the ray sees of the paper's scene.
Vec3<double> seen(const Ray<double>& ray) {
    const Vec3<double> P{200, 350, 100}, Q{200, 400, 100}, R{200, 375, 150}, S{250, 375, 100};
    const std::array<Sphere<double>, 2> spheres{{{{100, 350, 350}, 50}, {{50, 300, 300}, 20}}};
    const std::array<Triangle<double>, 4> triangles{{{P, Q, R}, {P, Q, S}, {P, S, R}, {Q, R, S}}};
    const Vec3<double> green{0, 255, 0}, red{255, 0, 0}, grey{128, 128, 128};
    const std::array<Vec3<double>, 6> colors{green, red, grey, grey, grey, grey};
    const Light<double> light = directional_light<double>({1000, 250, 250}, 1);
    const Shading<double> shading{ShadingModel::blinn_phong, 0.2, 1, 0.2, 15, {255, 102, 102}, {255, 255, 255}};

    Silent probe;
    std::optional<Hit<double>> hit;
    for (std::size_t k = 0; k < spheres.size(); ++k) hit = nearest(hit, k, intersect(ray, spheres[k], Stable{}, probe));
    for (std::size_t k = 0; k < triangles.size(); ++k)
        hit = nearest(hit, spheres.size() + k, intersect(ray, triangles[k], Pluecker{}, probe));
    if (!hit) return black;
    const std::size_t k = hit->surface;
    const Vec3<double> n =
        k < spheres.size() ? normal(spheres[k], at(ray, hit->t)) : normal(triangles[k - spheres.size()]);
    const Rgb color = to_rgb(shade(n, -unit(ray.D), colors[k], light, shading, probe));
    return to_vec3<double>(color);
}

int main(int argc, char** argv) {
    Picture picture(6 * size, 2 * size);
    picture.paint_part(0, 0, size, size, [](int j, int i) {  // each pixel looks up the house where R takes it
        const Rotation<double> R{{0.8, 0.6, 0}, {-0.6, 0.8, 0}, {0, 0, 1}};
        return house(R * Vec3<double>{j - 125.0, i - 125.0, 0});
    });
    picture.paint_part(size, 0, size, size, [](int j, int i) {  // quarter turns: S about z, R about x, and both
        const Rotation<double> S{y, -x, z}, R{x, z, -y};
        return balls(j, i, 2, [&](int k) { return k == 0 ? S : k == 1 ? R : k == 2 ? R * S : S * R; });
    });
    picture.paint_part(2 * size, 0, size, size, [](int j, int i) {
        const std::array<Turn<double>, 4> turns{{{Axis::z, 0}, {Axis::x, 30}, {Axis::y, 30}, {Axis::z, 30}}};
        return balls(j, i, 2, [&](int k) { return rotation(turns[static_cast<std::size_t>(k)]); });
    });
    picture.paint_part(3 * size, 0, size, size, [](int j, int i) {  // quarter turns about z, x, z, x, …: k of them
        return balls(j, i, 3, [](int k) {
            std::vector<Turn<double>> turns;
            for (int n = 0; n < k; ++n) turns.push_back({n % 2 == 0 ? Axis::z : Axis::x, 90});
            return rotation<double>(turns);
        });
    });
    picture.paint_part(4 * size, 0, size, size, [](int j, int i) {  // one house, half as large, turned about the pivot
        const Vec3<double> pivot{125, 125, 0}, middle{125, 205, 0}, pixel{double(j), double(i), 0};
        Vec3<double> color = house({1000, 1000, 0});
        for (int k = 5; k >= 0; --k) {
            const Turn<double> turn{Axis::z, 60.0 * k};
            const Vec3<double> here = house(2 * (turned(pixel, rotation(turn), pivot) - middle));
            if (here != house({1000, 1000, 0})) color = here;
        }
        return color;
    });
    picture.paint_part(5 * size, 0, size, size, [](int j, int i) {  // planes from above, every 50th pixel; 5 units here
        const Vec3<double> pivot{100, 350, 0}, here = pivot + 5 * Vec3<double>{j - 125.0, i - 125.0, 0};
        if (length(here - pivot) <= 20) return white;
        for (int k = 0; k < 12; ++k) {
            const Turn<double> turn{Axis::z, 30.0 * k};
            const ViewingPlane<double> straight{{500, 0, 0}, {0, 1, 0}, {0, 0, 1}};
            const ViewingPlane<double> plane = turned(straight, rotation(turn), pivot);
            for (int n = 0; n <= 500; n += 50)
                if (length(point(plane, n, 0) - here) <= (n == 0 ? 20 : 10)) return orange + k / 11.0 * (blue - orange);
        }
        return black;
    });
    picture.paint_part(0, size, 4 * size, size, [](int j, int i) {  // every second pixel of the paper's
        const Parallel<double> straight{{{500, 0, 0}, {0, 2, 0}, {0, 0, 2}}, {-1, 0, 0}};
        const Turn<double> turn{Axis::z, 10.0 * (j / size)};
        const Parallel<double> view = turned(straight, rotation(turn), {0, 0, 0});
        return seen(pixel_ray(view, j % size, i));
    });
    picture.paint_part(4 * size, size, 2 * size, size, [](int j, int i) {  // about the green ball's middle
        const Pinhole<double> straight = looking<double>({700, 350, 250}, {0, 350, 250}, z, 45, size, size);
        const Turn<double> turn{Axis::z, 60.0 * (j / size)};
        const Pinhole<double> view = turned(straight, rotation(turn), {100, 350, 350});
        return seen(pixel_ray(view, j % size, i));
    });
    return picture.write(argc > 1 ? argv[1] : "rotation.ppm");
}
