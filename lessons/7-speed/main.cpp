// Lesson 7: what a ray looks at. A bumpy ball of 9600 triangles on a floor of 2, on the left as it is seen; on the
// right how many boxes each pixel's ray was tested against: black 0, red 51, yellow 102, white 153 or more.
#include <cmath>
#include <cstdio>
#include <intersect_triangle.hpp>
#include <numbers>
#include <picture.hpp>
#include <probe.hpp>
#include <vector>
#include <viewing_plane.hpp>

#include <box.hpp>
#include <tree.hpp>
#include <walk.hpp>

using namespace glassbox;

namespace {

constexpr int size = 320;

using Triangles = std::vector<Triangle<double>>;

/// The ball's point of that longitude and latitude, both in radians.
Vec3<double> on_ball(double longitude, double latitude) {
    const double r = 1 + 0.12 * std::cos(7 * longitude) * std::cos(9 * latitude) * std::cos(latitude);
    const double beside = r * std::cos(latitude);
    return {beside * std::cos(longitude), beside * std::sin(longitude), r * std::sin(latitude)};
}

Triangles ball_on_a_floor() {
    constexpr int around = 80, upwards = 60;
    constexpr double pi = std::numbers::pi;
    const auto at = [](int i, int j) { return on_ball(2 * pi * i / around, pi * j / upwards - pi / 2); };
    Triangles triangles;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < upwards; ++j) {
            const Vec3<double> a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
            triangles.push_back({a, b, c});
            triangles.push_back({a, c, d});
        }
    const Vec3<double> a{-2, -2, -1}, b{2, -2, -1}, c{2, 2, -1}, d{-2, 2, -1};
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
    return triangles;
}

/// The probe that counts boxes.
struct Counting {
    int boxes = 0;

    template <class What, class... Values>
    void operator()(What, const Values&...) {}
    void operator()(told::BoxTested) { ++boxes; }
};

/// Black, red, yellow, white.
Vec3<int> heat(int count) {
    const auto channel = [&](int from) { return std::clamp(5 * count - from, 0, 255); };
    return {channel(0), channel(255), channel(510)};
}

}  // namespace

int main(int argc, char** argv) {
    const Triangles triangles = ball_on_a_floor();
    std::vector<engine::Box> boxes;
    for (const Triangle<double>& triangle : triangles) boxes.push_back(engine::box_of(triangle, {0, 0, 0}));
    const engine::Tree tree = engine::tree_over(boxes);

    const auto view = looking<double>({4.4, -3, 2.4}, {0, 0, -0.1}, {0, 0, 1}, 32, size, size);
    const Vec3<double> light = unit(Vec3<double>{2, -1, 2});
    Silent silent;
    double all_boxes = 0, all_triangles = 0;
    Picture picture(2 * size, size);
    for (int i = 0; i < size; ++i) {
        for (int j = 0; j < size; ++j) {
            const Ray<double> ray = pixel_ray(view, j, i);
            const auto test = [&](std::size_t surface) {
                ++all_triangles;
                return Pluecker{}(ray, triangles[surface], silent);
            };
            Counting counting;
            const auto hit = engine::walk(tree, ray, test, counting);
            all_boxes += counting.boxes;
            picture.paint(size + j, i, heat(counting.boxes));
            if (!hit) continue;
            const Vec3<double> n = normal(triangles[hit->surface]);
            const Vec3<double> full =
                hit->surface < triangles.size() - 2 ? Vec3<double>{250, 190, 90} : Vec3<double>{145, 165, 185};
            picture.paint(j, i, (0.1 + 0.9 * std::abs(dot(n, light))) * full);
        }
    }
    std::printf("a ray was tested against %.1f boxes and %.2f of %zu triangles\n", all_boxes / (size * size),
                all_triangles / (size * size), triangles.size());
    return picture.write(argc > 1 ? argv[1] : "speed.ppm");
}
