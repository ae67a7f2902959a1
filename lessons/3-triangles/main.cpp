// Lesson 3: a ray meets triangles. Six parts; the function named makes each appear:
//
//   4 plane_t   5 plane_t   6 normal
//   1 side      2 sides     3 inside
#include <array>
#include <cmath>
#include <intersect_sphere.hpp>
#include <intersect_triangle.hpp>
#include <picture.hpp>
#include <probe.hpp>
#include <viewing_plane.hpp>

using namespace glassbox;

constexpr int size = 250;  // each part, in pixels

const Vec3<double> night{18, 22, 34}, white{255, 255, 255}, orange{230, 120, 30}, blue{40, 90, 200};

/// 1 to 3: one triangle, and a compass rose of eight about one corner. The orange ones run counter-clockwise, the blue
/// ones clockwise.
const Triangle<double> one{{100, 45, 45}, {100, 205, 85}, {40, 85, 180}};
const Vec3<double> middle{100, 125, 125}, east{0, 235, 125}, north{0, 125, 235}, west{0, 15, 125}, south{0, 125, 15};
const Vec3<double> northeast{50, 165, 165}, northwest{50, 85, 165}, southwest{50, 85, 85}, southeast{50, 165, 85};
const std::array<Triangle<double>, 8> rose{{{middle, east, northeast},
                                            {middle, north, northeast},
                                            {middle, north, northwest},
                                            {middle, west, northwest},
                                            {middle, west, southwest},
                                            {middle, south, southwest},
                                            {middle, south, southeast},
                                            {middle, east, southeast}}};

/// 4 to 6: the paper's tetrahedron PQRS over a floor of two triangles, which share the edge from front to back; and a
/// ball stuck in it.
const Vec3<double> P{200, 350, 100}, Q{200, 400, 100}, R{200, 375, 150}, S{250, 375, 100};
const Vec3<double> front{325, 375, 80}, left{200, 275, 80}, back{75, 375, 80}, right{200, 475, 80};
const std::array<Triangle<double>, 6> triangles{
    {{P, Q, R}, {P, Q, S}, {P, S, R}, {Q, R, S}, {front, back, left}, {back, front, right}}};
const Sphere<double> ball{{212, 375, 112}, 17};
const std::array<Vec3<double>, 7> colors{
    {{150, 200, 255}, {150, 200, 255}, {150, 200, 255}, {80, 130, 235}, {70, 90, 80}, {70, 90, 80}, orange}};

/// The number of the surface that the ray meets first: the triangles', or for the ball the one after.
std::optional<Hit<double>> first_hit(const Ray<double>& ray, bool has_ball) {
    Silent probe;
    std::optional<Hit<double>> hit;
    for (std::size_t k = 0; k < triangles.size(); ++k)
        hit = nearest(hit, k, intersect(ray, triangles[k], Pluecker{}, probe));
    return has_ball ? nearest(hit, triangles.size(), intersect(ray, ball, Textbook{}, probe)) : hit;
}

/// A weight from 0 to 1 in steps of an eighth, as the brightness of a colour.
double level(double weight) { return 255 * std::sqrt(std::floor(8 * weight) / 8); }

int main(int argc, char** argv) {
    // 1 to 3 look along -x, a pixel a unit: column j, row i is the ray through (y, z) = (j, i).
    const Parallel<double> along_x{{{500, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {-1, 0, 0}};
    const Pinhole<double> aslant = looking<double>({400, 330, 190}, ball.C, {0, 0, 1}, 26, size, size);
    // 5: the eye's numbers are whole: the rays of the middle column pass exactly through the edges at y = 375.
    constexpr double step = 3 / 32.0;
    const Pinhole<double> near{{{400, 375 - 125 * step, 169}, {0, step, 0}, {0, 0, step}}, {450, 375, 200}};

    Picture picture(3 * size, 2 * size);
    picture.paint_part(0, 0, size, size, [&](int j, int i) {  // the side of AB: its sign, its size in bands, the edge
        const Ray<double> ray = pixel_ray(along_x, j, i);
        const Vec3<double> A = one.A - ray.P, B = one.B - ray.P, edge = B - A;
        const double distance = side(ray.D, A, B) / length(edge);
        const bool is_beside = dot(A, edge) <= 0 && dot(B, edge) >= 0;
        if (std::abs(distance) < (is_beside ? 2 : 0.5)) return white;
        const double band = std::fmod(std::floor(std::abs(distance) / 20), 2) == 0 ? 1 : 0.8;
        return distance > 0 ? band * orange : band * blue;
    });
    picture.paint_part(size, 0, size, size, [&](int j, int i) {  // the three signs, as red, green and blue
        const Ray<double> ray = pixel_ray(along_x, j, i);
        const auto [a, b, c] = sides(ray.D, seen_from(ray.P, one));
        return Vec3<double>{a > 0 ? 220.0 : 70, b > 0 ? 220.0 : 70, c > 0 ? 220.0 : 70};
    });
    picture.paint_part(2 * size, 0, size, size, [&](int j, int i) {  // inside one of the rose's, or of several
        const Ray<double> ray = pixel_ray(along_x, j, i);
        int count = 0;
        std::size_t last = 0;
        for (std::size_t k = 0; k < rose.size(); ++k) {
            if (!inside(sides(ray.D, seen_from(ray.P, rose[k])))) continue;
            ++count;
            last = k;
        }
        return count == 0 ? night : count > 1 ? white : last % 2 == 0 ? orange : blue;
    });
    picture.paint_part(0, size, size, size, [&](int j, int i) {  // what is nearest, with its t in bands of 5
        const auto hit = first_hit(pixel_ray(aslant, j, i), true);
        if (!hit) return night;
        return (std::fmod(std::floor(hit->t / 5), 2) == 0 ? 1 : 0.85) * colors[hit->surface];
    });
    picture.paint_part(size, size, size, size, [&](int j, int i) {  // the weights of A, B, C as red, green and blue
        const Ray<double> ray = pixel_ray(near, j, i);
        const auto hit = first_hit(ray, false);
        if (!hit) return night;
        const auto [a, b, c] = sides(ray.D, seen_from(ray.P, triangles[hit->surface]));
        const double sum = a + b + c;
        return Vec3<double>{level(a / sum), level(b / sum), level(c / sum)};
    });
    picture.paint_part(2 * size, size, size, size, [&](int j, int i) {  // x, y and z of the normal, from -1 to 1
        const Ray<double> ray = pixel_ray(aslant, j, i);
        const auto hit = first_hit(ray, true);
        if (!hit) return night;
        const bool is_ball = hit->surface == triangles.size();
        const Vec3<double> n = is_ball ? normal(ball, at(ray, hit->t)) : normal(triangles[hit->surface]);
        return 127.5 * (Vec3<double>{1, 1, 1} + n);
    });
    return picture.write(argc > 1 ? argv[1] : "triangles.ppm");
}
