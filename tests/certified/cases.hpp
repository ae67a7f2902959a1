#pragma once
#include <ray.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "../numerics/doubles.hpp"
#include "scene/scene.hpp"

/// Scenes and rays that are hard to decide: the same ones on every machine.
namespace glassbox::test {

using Point = Vec3<double>;
using Faces = std::vector<std::array<std::uint32_t, 3>>;

struct Case {
    std::string name;
    Scene scene;
    std::vector<Ray<double>> rays;
};

/// Fewer rays in checked builds, where everything is checked at every step.
#ifdef NDEBUG
constexpr int share = 1;
#else
constexpr int share = 8;
#endif

class Shapes {
public:
    struct Shape {
        std::string name;
        std::vector<Point> vertices;
        Faces faces;
    };

    static Shape tetrahedron() {
        return {"tetrahedron",
                {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
    }

    static Shape cube() {
        Shape shape{"cube", {}, {}};
        for (const double x : {-1.0, 1.0})
            for (const double y : {-1.0, 1.0})
                for (const double z : {-1.0, 1.0}) shape.vertices.push_back({x, y, z});
        for (const auto& [a, b, c, d] : {std::array<std::uint32_t, 4>{0, 1, 3, 2},
                                         {4, 6, 7, 5},
                                         {0, 4, 5, 1},
                                         {2, 3, 7, 6},
                                         {0, 2, 6, 4},
                                         {1, 5, 7, 3}}) {
            shape.faces.push_back({a, b, c});
            shape.faces.push_back({a, c, d});
        }
        return shape;
    }

    /// An octahedron, each face split into four again and again, projected onto a sphere.
    static Shape globe(int splits) {
        Shape shape{"globe",
                    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                    {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
        for (; splits > 0; --splits) {
            std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
            const auto middle = [&](std::uint32_t a, std::uint32_t b) {
                const auto [at, is_new] =
                    middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(shape.vertices.size()));
                if (is_new) shape.vertices.push_back(unit(shape.vertices[a] + shape.vertices[b]));
                return at->second;
            };
            Faces finer;
            for (const auto& [a, b, c] : shape.faces) {
                const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
                finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
            }
            shape.faces = finer;
        }
        return shape;
    }

    static Shape torus(std::uint32_t around, std::uint32_t across) {
        Shape shape{"torus", {}, {}};
        const double turn = 2 * std::acos(-1.0);
        for (std::uint32_t i = 0; i < around; ++i)
            for (std::uint32_t j = 0; j < across; ++j) {
                const double u = turn * i / around, v = turn * j / across, r = 0.7 + 0.3 * std::cos(v);
                shape.vertices.push_back({r * std::cos(u), r * std::sin(u), 0.3 * std::sin(v)});
                const auto at = [&](std::uint32_t k, std::uint32_t l) { return k % around * across + l % across; };
                shape.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
                shape.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
            }
        return shape;
    }

    /// `blades` triangles around the vertex 0, which stands out a little.
    static Shape fan(std::uint32_t blades) {
        Shape shape{"fan of " + std::to_string(blades), {{0, 0, 0.1}}, {}};
        for (std::uint32_t i = 0; i < blades; ++i) {
            const double angle = 2 * std::acos(-1.0) * (i + 0.3) / blades;
            shape.vertices.push_back({std::cos(angle), std::sin(angle), 0});
            shape.faces.push_back({0, 1 + i, 1 + (i + 1) % blades});
        }
        return shape;
    }
};

inline constexpr Point odd_direction{0.61, -0.53, 0.59};

/// Moved and scaled. On a grid every vertex is a multiple of 2⁻²⁰ of the scale, then a power of two, so that midpoints
/// and differences of vertices have no error.
inline Shapes::Shape placed(Shapes::Shape shape, double scale, double sizes_away, bool on_grid) {
    const auto snapped = [&](double x) { return on_grid ? std::round(x * 0x1p20) * 0x1p-20 : x; };
    const Point offset = sizes_away * odd_direction;
    for (Point& v : shape.vertices)
        v = {scale * snapped(v.x + offset.x), scale * snapped(v.y + offset.y), scale * snapped(v.z + offset.z)};
    return shape;
}

inline Scene scene_of(const Shapes::Shape& shape) {
    Scene scene;
    scene.meshes = {Mesh{shape.vertices, shape.faces, {}}};
    return scene;
}

class Rays {
public:
    explicit Rays(std::uint64_t seed) : random(seed) {}

    /// From anywhere, one to ten sizes away, towards Q, as well as doubles can.
    Ray<double> towards(const Point& Q, double size) {
        const Point P = Q + size * (1 + 9 * random.fraction()) * anywhere();
        return {P, Q - P};
    }

    /// Through Q exactly, for Q on the grid of `step`.
    Ray<double> exactly_through(const Point& Q, double step) {
        const auto few = [&] { return static_cast<double>(random.below(33)) - 16; };
        Point D{few(), few(), few()};
        if (D == Point{}) D.z = 1;
        const Point whole = step * D;
        return {Q - 0x1p18 * whole, random.one_in(2) ? whole : D};
    }

    /// A point of a face: a vertex, the middle of an edge, anywhere on an edge, anywhere inside.
    Point on_a_face(const Shapes::Shape& shape) {
        const auto& face = shape.faces[random.below(shape.faces.size())];
        const std::uint64_t first = random.below(3);
        const Point &A = shape.vertices[face[first]], &B = shape.vertices[face[(first + 1) % 3]],
                    &C = shape.vertices[face[(first + 2) % 3]];
        switch (random.below(5)) {
            case 0:
                return A;
            case 1:
                return 0.5 * A + 0.5 * B;
            case 2:
            case 3:
                return A + random.fraction() * (B - A);
            default: {
                const double u = random.fraction(), v = random.fraction() * (1 - u);
                return A + u * (B - A) + v * (C - A);
            }
        }
    }

    Point anywhere() {
        for (;;) {
            const Point p{2 * random.fraction() - 1, 2 * random.fraction() - 1, 2 * random.fraction() - 1};
            if (dot(p, p) > 0.01) return p;
        }
    }

    /// Makes some of the rays invalid.
    void spoil(std::vector<Ray<double>>& rays) {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
        for (std::size_t i = 50; i < rays.size(); i += 97) {
            double* const numbers[] = {&rays[i].P.x, &rays[i].P.y, &rays[i].P.z,
                                       &rays[i].D.x, &rays[i].D.y, &rays[i].D.z};
            if (random.one_in(4)) rays[i].D = {0.0, -0.0, 0.0};
            else *numbers[random.below(6)] = random.one_in(2) ? nan : random.sign() * inf;
        }
    }

    Doubles random;
};

/// Rays through vertices and edges of closed meshes and fans, at all scales and distances from the origin.
inline std::vector<Case> meshes() {
    std::vector<Case> cases;
    std::uint64_t seed = 100;
    for (const auto& shape : {Shapes::tetrahedron(), Shapes::cube(), Shapes::globe(3), Shapes::torus(16, 10),
                              Shapes::fan(3), Shapes::fan(4), Shapes::fan(8), Shapes::fan(24)})
        for (const double sizes_away : {0.0, 1.0, 30.0, 1000.0})
            for (const int magnitude : {-10, -3, 0, 3, 10})
                for (const bool on_grid : {true, false}) {
                    const double scale = on_grid ? std::ldexp(1, magnitude * 10 / 3) : std::pow(10, magnitude);
                    const Shapes::Shape there = placed(shape, scale, sizes_away, on_grid);
                    Rays rays(++seed);
                    Case c{there.name + " of size 1e" + std::to_string(magnitude) + ", " +
                               std::to_string(static_cast<int>(sizes_away)) + " sizes away" +
                               (on_grid ? ", on a grid" : ""),
                           scene_of(there),
                           {}};
                    for (int i = 0; i < 400 / share; ++i) {
                        const Point Q = rays.on_a_face(there);
                        c.rays.push_back(on_grid && i % 4 != 0 ? rays.exactly_through(Q, scale * 0x1p-20)
                                                               : rays.towards(Q, scale));
                    }
                    rays.spoil(c.rays);
                    cases.push_back(std::move(c));
                }
    return cases;
}

/// Kettner et al., "Classroom examples of robustness problems in geometric computations" (2008): starts one ulp apart.
inline std::vector<Ray<double>> grid_of_starts(const Ray<double>& first, double Point::*across, double Point::*up,
                                               int step) {
    constexpr int side = 256;
    std::vector<Ray<double>> rays;
    const auto ulp = [](double x) {
        return std::nextafter(std::abs(x), std::numeric_limits<double>::infinity()) - std::abs(x);
    };
    for (int i = 0; i < side; i += step)
        for (int j = 0; j < side; j += share) {
            Ray<double> ray = first;
            ray.P.*across += (i - side / 2) * ulp(ray.P.*across);
            ray.P.*up += (j - side / 2) * ulp(ray.P.*up);
            rays.push_back(ray);
        }
    return rays;
}

inline std::vector<Case> grids() {
    const auto quad = [](const Point& A, const Point& B, const Point& C, const Point& D) {
        Scene scene;
        scene.meshes = {Mesh{{A, B, C, D}, {{0, 1, 2}, {0, 2, 3}}, {}}};
        return scene;
    };
    const Scene flat = quad({0, 0, 0}, {24, 0, 0}, {24, 24, 0}, {0, 24, 0});
    const Point A{12.1, 12.3, -0.7}, C{24.3, 25.9, 3.1};
    const Scene tilted = quad(A, {26.3, 11.7, 0.3}, C, {13.7, 27.1, 1.9});
    const Point Q = A + 0.37 * (C - A), D{0.3, -0.2, -1};
    Scene ball;
    ball.spheres = {{{0.1, 0.2, 0.3}, 1.7, {}}};
    const Point on_it{0.1 + 1.7 * 0.6, 0.2 + 1.7 * 0.8, 0.3};
    return {
        {"a diagonal, from above", flat, grid_of_starts({{0.5, 0.5, 10}, {0, 0, -1}}, &Point::x, &Point::y, 1)},
        {"a diagonal, aslant", tilted, grid_of_starts({Q - 10.0 * D, D}, &Point::x, &Point::y, 2)},
        {"starts on a face, aslant", tilted,
         grid_of_starts({Q + 0.1 * (Point{13.7, 27.1, 1.9} - Q), D}, &Point::x, &Point::z, 2)},
        {"starts on a sphere, inwards", ball, grid_of_starts({on_it, {-0.3, -0.5, 0.2}}, &Point::x, &Point::y, 2)},
        {"starts on a sphere, outwards", ball, grid_of_starts({on_it, {0.3, 0.5, 0.2}}, &Point::x, &Point::y, 2)},
        {"tangents", ball,
         grid_of_starts({on_it - 3.0 * Point{-0.8, 0.6, 0}, {-0.8, 0.6, 0}}, &Point::x, &Point::y, 2)},
        {"tangents, aslant", ball, grid_of_starts({{on_it.x, on_it.y, -4}, {0, 0, 1}}, &Point::x, &Point::y, 2)},
    };
}

/// Surfaces at exactly the same distance, and nearly so.
inline std::vector<Case> ties() {
    Rays rays(300);
    std::vector<Case> cases;
    const auto corner = [&] { return Point{rays.random.fraction(), rays.random.fraction(), rays.random.fraction()}; };
    const auto triangle = [](const Point& A, const Point& B, const Point& C) { return ColoredTriangle{{A, B, C}, {}}; };
    for (int i = 0; i < 300 / share; ++i) {
        Case same{"the same triangle, its vertices in another order", {}, {}};
        const Point A = corner(), B = corner(), C = corner();
        same.scene.triangles = {triangle(A, B, C), triangle(C, A, B), triangle(B, A, C), triangle(A, B, corner())};
        const Shapes::Shape shape{"", {A, B, C}, {{0, 1, 2}}};
        for (int k = 0; k < 24; ++k) same.rays.push_back(rays.towards(rays.on_a_face(shape), 1));
        cases.push_back(std::move(same));

        // Corners A + iE + jF with whole i and j: on one plane, exactly.
        Case coplanar{"overlapping triangles in one plane", {}, {}};
        const auto few = [&](double step) {
            const auto number = [&] { return step * (static_cast<double>(rays.random.below(65)) - 32); };
            return Point{number(), number(), number()};
        };
        const Point O = few(0x1p-3), E = few(0x1p-6), F = few(0x1p-6);
        const auto on_plane = [&] {
            return O + (static_cast<double>(rays.random.below(17)) - 8) * E +
                   (static_cast<double>(rays.random.below(17)) - 8) * F;
        };
        Shapes::Shape plane{"", {}, {}};
        for (std::uint32_t k = 0; k < 6; ++k) {
            const Point a = on_plane(), b = on_plane(), c = on_plane();
            coplanar.scene.triangles.push_back(triangle(a, b, c));
            plane.vertices.insert(plane.vertices.end(), {a, b, c});
            plane.faces.push_back({3 * k, 3 * k + 1, 3 * k + 2});
        }
        for (int k = 0; k < 16; ++k) {
            coplanar.rays.push_back(rays.towards(rays.on_a_face(plane), 1));
            coplanar.rays.push_back({on_plane() - few(0x1p-5), few(0x1p-5)});
            coplanar.rays.push_back({on_plane(), on_plane() - on_plane()});  // edge-on
            coplanar.rays.push_back({on_plane(), few(1)});                   // t = 0
            Ray<double> nearly{on_plane(), on_plane() - on_plane()};
            nearly.P.x = std::nextafter(nearly.P.x, rays.random.sign() * 1e9);
            coplanar.rays.push_back(nearly);
        }
        rays.spoil(coplanar.rays);
        cases.push_back(std::move(coplanar));
    }

    Case round{"spheres that touch, coincide and cross, and planes that touch them", {}, {}};
    round.scene.spheres = {{{0, 0, 0}, 5, {}},  {{0, 0, 2}, 3, {}},  {{0, 0, 0}, 5, {}}, {{1, 0, 0}, 6, {}},
                           {{-1, 0, 0}, 6, {}}, {{0, 3, -4}, 5, {}}, {{8, 0, 0}, 3, {}}, {{0, 0, 8}, 3, {}}};
    round.scene.triangles = {triangle({-9, -9, 5}, {9, -9, 5}, {0, 9, 5}),
                             triangle({5, -9, -9}, {5, 9, -9}, {5, 0, 9})};
    for (int i = 0; i < 8000 / share; ++i) {
        const auto number = [&] { return static_cast<double>(rays.random.below(33)) - 16; };
        // In the plane x = 0 the spheres at (±1, 0, 0) are met at the same, irrational, t.
        Ray<double> ray{{i % 2 == 0 ? 0 : number(), number(), number()},
                        {i % 2 == 0 ? 0 : number(), number(), number()}};
        if (i % 5 == 0) ray = {{0, 0, number()}, {0, 0, number()}};
        if (i % 7 == 0) ray.P.x = rays.random.sign() * 0x1p-60;
        round.rays.push_back(ray);
    }
    rays.spoil(round.rays);
    cases.push_back(std::move(round));
    return cases;
}

/// Triangles of no area, or nearly none.
inline std::vector<Case> slivers() {
    Rays rays(400);
    std::vector<Case> cases;
    for (int i = 0; i < 500 / share; ++i) {
        Case c{"slivers", {}, {}};
        const double scale = rays.random.positive(-20, 20);
        const Point A = scale * rays.anywhere(), E = scale * rays.anywhere();
        const Point exact_E = convert<double>(convert<float>(E)), exact_A = convert<double>(convert<float>(A));
        const auto bent = [&](Point p) {
            p.y = std::nextafter(p.y, rays.random.sign() * 1e9);
            return p;
        };
        const Point B = exact_A + exact_E, C = exact_A + 2.0 * exact_E;
        for (const auto& [a, b, d] : {std::array<Point, 3>{A, A, A},
                                      {A, A + E, A},
                                      {exact_A, B, C},
                                      {C, bent(B), exact_A},
                                      {A, A + E, A + 0.3 * E},
                                      {A, A + E, A + rays.random.fraction() * E}})
            c.scene.triangles.push_back({{a, b, d}, {}});
        for (int k = 0; k < 12; ++k) {
            c.rays.push_back(rays.towards(A + rays.random.fraction() * E, scale));
            c.rays.push_back(rays.towards(exact_A + 0.5 * exact_E, scale));
            c.rays.push_back({exact_A - exact_E, exact_E});
            const Point across = 0x1p-30 * rays.anywhere();
            c.rays.push_back({exact_A + (0.1 + rays.random.fraction()) * exact_E - across, across});
        }
        rays.spoil(c.rays);
        cases.push_back(std::move(c));
    }
    return cases;
}

/// Spheres far, grazed, huge and tiny; rays that start inside, on the surface, and beyond.
inline std::vector<Case> spheres() {
    std::vector<Case> cases;
    Rays rays(500);
    const auto nudged = [](double x, int ulps) {
        for (; ulps > 0; --ulps) x = std::nextafter(x, std::numeric_limits<double>::infinity());
        for (; ulps < 0; ++ulps) x = std::nextafter(x, -std::numeric_limits<double>::infinity());
        return x;
    };
    const auto sphere = [](const Point& c, double r) { return ColoredSphere{c, r, {}}; };
    for (const auto& [r, away] : {std::pair{0.1, 400.0},
                                  {0.1, 1e6},
                                  {0.1, 1e8},
                                  {1e10, 2e10},
                                  {1e10, 1e10},
                                  {1.0, 3.0},
                                  {1.0, 1e-9},
                                  {0x1p-600, 0x1p-598},
                                  {0x1p-600, 1.0},
                                  {0x1p-300, 0x1p-200},
                                  {0x1p500, 0x1p501},
                                  {0x1.8p600, 0x1p603}}) {
        Case c{"a sphere of radius 2^" + std::to_string(std::ilogb(r)) + ", 2^" + std::to_string(std::ilogb(away)) +
                   " away",
               {},
               {}};
        const Point centre = away * odd_direction;
        c.scene.spheres = {sphere(centre, r), sphere({0, 0, away}, r)};
        for (int i = 0; i < 2000 / share; ++i) {
            // Towards the centre, but off it by so much that the ray grazes.
            const Point across = unit(cross(odd_direction, rays.anywhere()));
            const double by =
                i % 3 == 0 ? r * 1.2 * rays.random.fraction() : r * (1 + (rays.random.fraction() - 0.5) * 0x1p-40);
            const Point Q = centre + by * across;
            c.rays.push_back({Q - away * (0.5 + rays.random.fraction()) * odd_direction, odd_direction});
            if (i % 4 == 0) c.rays.back() = {{0, 0, 0}, Q};
            // Along z, tangent to the second sphere exactly, and an ulp or two off it.
            c.rays.push_back({{nudged(r, static_cast<int>(i % 5) - 2), 0, i % 2 == 0 ? 0 : 3 * away},
                              {0, i % 7 == 0 ? 0x1p-1000 : 0, i % 11 == 0 ? -1.0 : 1.0}});
            // From inside, or close to it; straight to the centre.
            c.rays.push_back({centre + r * rays.random.fraction() * rays.anywhere(), r * rays.anywhere()});
            if (i % 16 == 0) c.rays.push_back({{0, 0, 0}, centre});
        }
        rays.spoil(c.rays);
        cases.push_back(std::move(c));
    }

    // (3, 4, 0), (0, 3, 4), … lie on the sphere of radius 5, and the tangent there has whole numbers, too.
    Case whole{"starts on a sphere, and tangents, in whole numbers", {}, {}};
    whole.scene.spheres = {sphere({0, 0, 0}, 5), sphere({0, 0, 0}, 0x1p-3), sphere({0, 0, 0}, 25),
                           sphere({7, 24, 0}, 25)};
    for (int i = 0; i < 6000 / share; ++i) {
        const auto sign = [&] { return rays.random.sign(); };
        const auto number = [&] { return static_cast<double>(rays.random.below(17)) - 8; };
        double p[3] = {3 * sign(), 4 * sign(), 0}, q[3] = {-p[1], p[0], number()};
        const auto k = static_cast<std::size_t>(i % 3);
        const Point P{p[k], p[(k + 1) % 3], p[(k + 2) % 3]}, T{q[k], q[(k + 1) % 3], q[(k + 2) % 3]};
        whole.rays.push_back({P, {number(), number(), number()}});
        whole.rays.push_back({P, T});
        whole.rays.push_back({P - number() * T, T});
        Ray<double> nearly{P - 8.0 * T, T};
        nearly.P.x = nudged(nearly.P.x, sign() > 0 ? 1 : -1);
        whole.rays.push_back(nearly);
    }
    rays.spoil(whole.rays);
    cases.push_back(std::move(whole));
    return cases;
}

/// Triangles and rays so large or small that products overflow and underflow; directions of any length.
inline std::vector<Case> magnitudes() {
    std::vector<Case> cases;
    std::uint64_t seed = 600;
    for (const int size : {-1000, -700, -540, -360, -100, 0, 100, 340, 600, 900})
        for (const auto& shape : {Shapes::tetrahedron(), Shapes::globe(1)}) {
            const double scale = std::ldexp(1, size);
            for (const bool on_grid : {true, false}) {
                const Shapes::Shape there = placed(shape, scale, on_grid ? 0 : 1, on_grid);
                Case c{there.name + " of size 2^" + std::to_string(size), scene_of(there), {}};
                Rays rays(++seed);
                for (int i = 0; i < 600 / share; ++i) {
                    const Point Q = rays.on_a_face(there);
                    Ray<double> ray =
                        on_grid && i % 2 == 0 ? rays.exactly_through(Q, scale * 0x1p-20) : rays.towards(Q, scale);
                    const double length = std::ldexp(1, static_cast<int>(rays.random.below(1001)) - 500);
                    ray.D = length * (std::ldexp(1, i % 4 == 0 ? 0 : -size) * ray.D);
                    if (!is_finite(ray.D)) continue;
                    c.rays.push_back(ray);
                }
                rays.spoil(c.rays);
                cases.push_back(std::move(c));
            }
        }
    return cases;
}

/// All sizes in one scene, and in turn rays that only one of them is made for.
inline Case all_sizes() {
    Case c{"all sizes in one scene", {}, {}};
    Rays rays(700);
    for (int i = 0; i < 2000 / share; ++i) {
        const double scale = std::ldexp(1, static_cast<int>(rays.random.below(1100)) - 550);
        const Shapes::Shape there = placed(Shapes::tetrahedron(), scale, 0, i % 2 == 0);
        if (i < 6) {
            c.scene.meshes.push_back(Mesh{there.vertices, there.faces, {}});
            c.scene.spheres.push_back({scale * rays.anywhere(), 0.3 * scale, {}});
        }
        Ray<double> ray = rays.towards(rays.on_a_face(there), scale);
        const Mesh& mesh = c.scene.meshes[rays.random.below(c.scene.meshes.size())];
        if (i % 4 == 0) ray.D = mesh.vertices[rays.random.below(4)] - ray.P;
        if (i % 4 == 1) ray = {-1.0 * mesh.vertices[0], 0.5 * mesh.vertices[1] + 1.5 * mesh.vertices[0]};
        c.rays.push_back(ray);
    }
    rays.spoil(c.rays);
    return c;
}

/// Nothing special: triangles and spheres of about size 1 in random places in a box, rays from anywhere to anywhere.
inline Case anything() {
    Case c{"triangles and spheres in a box", {}, {}};
    Rays rays(800);
    for (int i = 0; i < 12; ++i) {
        const Point at = 3.0 * rays.anywhere();
        c.scene.triangles.push_back({{at + rays.anywhere(), at + rays.anywhere(), at + rays.anywhere()}, {}});
        if (i % 3 == 0) c.scene.spheres.push_back({3.0 * rays.anywhere(), 0.2 + rays.random.fraction(), {}});
    }
    for (int i = 0; i < 450'000 / share; ++i) {
        const Point P = 5.0 * rays.anywhere();
        c.rays.push_back({P, 3.0 * rays.anywhere() - P});
    }
    rays.spoil(c.rays);
    return c;
}

}  // namespace glassbox::test
