// Lesson 3: a tetrahedron joins the spheres: four triangles, each tested by its three side products. On the left the
// paper's view in flat colours; on the right the tetrahedron from near, over a floor of two triangles. There the colour
// is the weight of each corner, in eighths: A is red, B green, C blue.
#include <algorithm>
#include <array>
#include <cmath>
#include <picture.hpp>
#include <probe.hpp>
#include <sphere.hpp>
#include <triangle.hpp>
#include <viewing_plane.hpp>

using namespace glassbox;

/// The weights of the three corners, in eighths, as red, green and blue.
Vec3<double> weight_color(const Ray<double>& ray, const Triangle<double>& triangle) {
    const auto [a, b, c] = sides(ray.D, seen_from(ray.P, triangle));
    const double sum = a + b + c;
    const auto level = [sum](double weight) { return 255.0 / 8 * std::clamp(std::floor(8 * weight / sum), 0.0, 8.0); };
    return {level(a), level(b), level(c)};
}

int main(int argc, char** argv) {
    constexpr int width = 500, height = 500;
    const Parallel<double> paper{{{500, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {-1, 0, 0}};
    // The eye's numbers are whole: the rays of the middle column pass exactly through the edges at y = 375.
    constexpr double step = 3 / 64.0;
    const Pinhole<double> near{{{400, 375 - 250 * step, 169}, {0, step, 0}, {0, 0, step}}, {450, 375, 200}};

    const std::array<Sphere<double>, 2> spheres{{{{100, 350, 350}, 50}, {{50, 300, 300}, 20}}};
    const Vec3<double> P{200, 350, 100}, Q{200, 400, 100}, R{200, 375, 150}, S{250, 375, 100};
    const Vec3<double> front{325, 375, 80}, left{200, 275, 80}, back{75, 375, 80}, right{200, 475, 80};
    // four for the tetrahedron, two for the floor; they share the edge from front to back
    const std::array<Triangle<double>, 6> triangles{
        {{P, Q, R}, {P, Q, S}, {P, S, R}, {Q, R, S}, {front, back, left}, {back, front, right}}};
    // surfaces are numbered: the spheres, then the triangles
    const Vec3<double> green{0, 255, 0}, red{255, 0, 0}, grey{128, 128, 128};
    const std::array<Vec3<double>, 6> colors{green, red, grey, grey, grey, grey};

    Silent probe;
    Picture picture(2 * width, height);
    for (int i = 0; i < height; ++i) {
        for (int j = 0; j < width; ++j) {
            const Ray<double> ray = pixel_ray(paper, j, i);
            std::optional<Hit<double>> hit;
            for (std::size_t k = 0; k < 2; ++k) hit = nearest(hit, k, intersect(ray, spheres[k], Textbook{}, probe));
            for (std::size_t k = 0; k < 4; ++k)  // without the floor
                hit = nearest(hit, 2 + k, intersect(ray, triangles[k], Pluecker{}, probe));
            if (hit) picture.paint(j, i, colors[hit->surface]);

            hit.reset();
            const Ray<double> close = pixel_ray(near, j, i);
            for (std::size_t k = 0; k < 6; ++k)
                hit = nearest(hit, k, intersect(close, triangles[k], Pluecker{}, probe));
            if (hit) picture.paint(width + j, i, weight_color(close, triangles[hit->surface]));
        }
    }
    return picture.write(argc > 1 ? argv[1] : "triangles.ppm");
}
