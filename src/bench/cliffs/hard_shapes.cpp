#include <array>
#include <cmath>
#include <numbers>

#include "bench/cliffs/cliff.hpp"
#include "bench/cliffs/shapes.hpp"

namespace glassbox {

namespace {

using namespace shape;

constexpr std::uint32_t thousand = 1000;

/// Long triangles in all directions, `thin` wide.
Traced long_triangles(double thin, int side) {
    Random random(5);
    std::array<Vec3<double>, 3> now{};
    const auto corner = [&](std::uint32_t, std::uint32_t k) {
        if (k == 0) {
            now[0] = random_point(random, -1, 1);
            now[1] = random_point(random, -1, 1);
            now[2] = now[1] + thin * random_point(random, -1, 1);
        }
        return now[k];
    };
    return {with(seen_from({0, 0, 4}, {0, 0, 0}, side), separate_triangles(thousand, corner))};
}

/// Long triangles seen by parallel rays from above; if `step` is not 0 with corners at multiples of it, many of them
/// on rays, and edges that cross there.
Traced on_a_lattice(double step, int side) {
    Random random(13);
    const auto corner = [&](std::uint32_t, std::uint32_t) {
        const Vec3<double> p = random_point(random, 0, 1);
        if (step == 0) return p;
        const auto multiple = [step](double a) { return std::round(a / step) * step; };
        return Vec3<double>{multiple(p.x), multiple(p.y), multiple(p.z)};
    };
    return {with(seen_from_above(1, side), separate_triangles(thousand, corner))};
}

/// Triangles that all have one edge in common.
Traced about_an_edge(int side) {
    Random random(15);
    const auto corner = [&](std::uint32_t, std::uint32_t k) {
        const Vec3<double> third = random_point(random, -1, 1);
        return k == 0 ? Vec3<double>{-0.5, 0, 1} : k == 1 ? Vec3<double>{0.5, 0.25, 1} : third;
    };
    return {with(seen_from({0, 0, 4}, {0, 0, 0}, side), separate_triangles(thousand, corner))};
}

/// A thousand triangles that fill the picture, a little way one behind the other.
Traced layers(int side) {
    const Vec3<double> corners[3]{{-3, -2, 0.25}, {3, -2, 0}, {0, 4, 0}};
    const auto corner = [&](std::uint32_t i, std::uint32_t k) { return corners[k] - Vec3<double>{0, 0, 0.001 * i}; };
    return {with(seen_from({0, 0, 2}, {0, 0, 0}, side), separate_triangles(thousand, corner))};
}

/// A thousand spheres about one point.
Traced concentric(const Vec3<double>& eye, int side) {
    Scene scene = seen_from(eye, eye + Vec3<double>{0, 0, -1}, side);
    for (std::uint32_t i = 1; i <= thousand; ++i) scene.spheres.push_back({{0, 0, 0}, 0.001 * i, grey});
    return {scene};
}

Traced balls(int side) { return {loose_balls(10, seen_from({4.5, 4.5, 20}, {4.5, 4.5, 4.5}, side))}; }

/// Spheres of one size that overlap nearly wholly.
Traced crowded(int side) {
    Random random(7);
    Scene scene = seen_from({0, 0, 4}, {0, 0, 0}, side);
    for (std::uint32_t i = 0; i < thousand; ++i) scene.spheres.push_back({random_point(random, -0.01, 0.01), 1, grey});
    return {scene};
}

/// Triangles without any area: their corners lie on a line.
Traced without_area(int side) {
    Random random(9);
    std::array<Vec3<double>, 3> now{};
    const auto corner = [&](std::uint32_t, std::uint32_t k) {
        if (k == 0) {
            now[0] = random_point(random, -1, 1);
            now[1] = now[0] + Vec3<double>{0.25, 0, 0};
            now[2] = now[0] + Vec3<double>{0.5, 0, 0};
        }
        return now[k];
    };
    return {with(seen_from({0, 0, 4}, {0, 0, 0}, side), separate_triangles(thousand, corner))};
}

/// A mesh in one plane, of 3,200 triangles, and an eye in or over the plane.
Traced flat(double height, int side) {
    Mesh mesh = terrain(40);
    for (Vec3<double>& v : mesh.vertices) v = {v.x, 0, v.y};
    return {with(seen_from({0, height, 3}, {0, 0, 0}, side), std::move(mesh))};
}

Traced thousand_hills(int side) { return {hills(thousand, side)}; }

}  // namespace

std::vector<Cliff> cliffs_of_shapes() {
    return {
        {"1,000 slivers, a millionth as wide as long", 5, "1,000 triangles of that length",
         [](int side) { return long_triangles(1e-6, side); }, [](int side) { return long_triangles(0.3, side); }},
        {"1,000 triangles one behind the other", 5, "hills of 968 triangles", layers, thousand_hills},
        {"1,000 long triangles with corners in eighths", 10, "with any corners",
         [](int side) { return on_a_lattice(0.125, side); }, [](int side) { return on_a_lattice(0, side); }},
        {"1,000 triangles about one edge", 5, "1,000 triangles of that length", about_an_edge,
         [](int side) { return long_triangles(0.3, side); }},
        {"1,000 triangles without area", 5, "hills of 968 triangles", without_area, thousand_hills},
        {"3,200 triangles in a plane, the eye in it", 5, "the eye over it", [](int side) { return flat(0, side); },
         [](int side) { return flat(1, side); }},
        {"1,000 concentric spheres", 5, "1,000 separate ones",
         [](int side) {
             return concentric({0, 0, 3}, side);
         },
         balls},
        {"1,000 concentric spheres from their centre", 5, "1,000 separate ones",
         [](int side) {
             return concentric({0, 0, 0}, side);
         },
         balls},
        {"1,000 spheres that nearly coincide", 5, "1,000 separate ones", crowded, balls},
    };
}

}  // namespace glassbox
