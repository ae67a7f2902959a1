// Lesson 4: light on two balls and a tetrahedron. Six parts, one for each step:
//
//   4 halfway       5 reflected   6 specular, and all together
//   1 positive_part 2 towards     3 diffuse
#include <array>
#include <cmath>
#include <intersect_sphere.hpp>
#include <intersect_triangle.hpp>
#include <picture.hpp>
#include <probe.hpp>
#include <shade.hpp>
#include <viewing_plane.hpp>

using namespace glassbox;

constexpr int size = 250;  // each part, in pixels

const Vec3<double> white{255, 255, 255}, sky{70, 90, 120}, green{0, 255, 0}, red{255, 0, 0}, grey{128, 128, 128};

const std::array<Sphere<double>, 2> spheres{{{{100, 90, 160}, 70}, {{100, 190, 190}, 35}}};
const Vec3<double> P{200, 130, 30}, Q{200, 230, 30}, R{200, 180, 130}, S{300, 180, 30};
// QSR is the face on the right, listed clockwise: its normal points into the tetrahedron.
const std::array<Triangle<double>, 4> triangles{{{P, Q, R}, {P, Q, S}, {P, S, R}, {Q, S, R}}};
const std::array<Vec3<double>, 6> colors{green, red, grey, grey, grey, grey};

/// What the ray meets first.
std::optional<Hit<double>> first_hit(const Ray<double>& ray) {
    Silent probe;
    std::optional<Hit<double>> hit;
    for (std::size_t k = 0; k < spheres.size(); ++k) hit = nearest(hit, k, intersect(ray, spheres[k], Stable{}, probe));
    for (std::size_t k = 0; k < triangles.size(); ++k)
        hit = nearest(hit, spheres.size() + k, intersect(ray, triangles[k], Pluecker{}, probe));
    return hit;
}

/// The unit normal of a surface, on whichever side it points to.
Vec3<double> surface_normal(std::size_t k, const Vec3<double>& X) {
    return k < spheres.size() ? normal(spheres[k], X) : normal(triangles[k - spheres.size()]);
}

/// A cosine as a grey, in bands of 0.1.
Vec3<double> bands(double cosine) {
    const double x = positive_part(cosine);
    return std::fmod(std::floor(10 * x), 2) == 0 ? 0.7 * x * white : x * white;
}

int main(int argc, char** argv) {
    // A pixel is a unit: column j, row i is the ray through (y, z) = (j, i), along -x.
    const Parallel<double> view{{{500, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {-1, 0, 0}};
    const Vec3<double> r{1, 0, 0};  // towards the viewer
    const Light<double> light = directional_light<double>({1, 2, 2}, 1);
    const Vec3<double> l = light.l;
    const Shading<double> shading{ShadingModel::blinn_phong, 0.2, 0.8, 0.4, 15, {255, 102, 102}, white};

    Picture picture(3 * size, 2 * size);
    // Part k: `shaded(n, color)` is the colour of a point whose surface has that normal and that colour.
    const auto part = [&](int k, const auto& shaded) {
        picture.paint_part((k - 1) % 3 * size, (k - 1) / 3 * size, size, size, [&](int j, int i) {
            const Ray<double> ray = pixel_ray(view, j, i);
            const auto hit = first_hit(ray);
            return hit ? shaded(surface_normal(hit->surface, at(ray, hit->t)), colors[hit->surface]) : sky;
        });
    };
    using V = Vec3<double>;
    part(1, [&](const V& n, const V&) { return positive_part(dot(n, l)) * white; });
    part(2, [&](const V& n, const V&) { return positive_part(dot(towards(r, n), l)) * white; });
    part(3, [&](const V& n, const V& color) {
        return diffuse(light.intensity, shading.k_d, dot(towards(r, n), l)) * color;
    });
    part(4, [&](const V& n, const V&) { return bands(dot(towards(r, n), halfway(l, r))); });
    part(5, [&](const V& n, const V&) { return bands(dot(r, reflected(l, n))); });
    part(6, [&](const V& n, const V& color) {
        Silent probe;
        return to_vec3<double>(to_rgb(shade(n, r, color, light, shading, probe)));
    });
    return picture.write(argc > 1 ? argv[1] : "shading.ppm");
}
