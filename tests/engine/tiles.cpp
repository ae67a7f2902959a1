// Tiles of rays against rays traced one by one: what a tile decides is right, and it decides nearly everything.
#include <doctest.h>

#include <algorithm>
#include <atomic>
#include <functional>

#include "../certified/cases.hpp"
#include "engine/kernels.hpp"
#include "every_kind_of_vectors.hpp"
#include "render/search/build_engine.hpp"
#include "render/search/certified_search.hpp"
#include "render/search/fast_search.hpp"
#include "render/tiles.hpp"

using namespace glassbox;
using test::Point;
using test::Rays;
using test::Shapes;

namespace {

struct Counts {
    int pixels = 0, told = 0, hits = 0;
};

/// Checks every pixel of a scene's picture. Where doubles can hardly tell the pixels apart, each ray's D is rounded by
/// a percent or more, and so is its t, which is in units of |D|.
Counts check(const std::string& name, const Scene& scene, bool pixels_apart = true) {
    CAPTURE(name);
    const View seen = view(scene, {});
    const CertifiedSearch truth(surfaces<double>(scene, 5), {}, {}, reach(seen, scene.width, scene.height), false);
    Counts counts;
    int wrong = 0, far_off = 0;
    trace_tiles(*build_engine(scene, 5, 1), seen, scene.width, scene.height, {1, {}, nullptr},
                [&](int x, int y, std::uint32_t surface, double t) {
                    ++counts.pixels;
                    if (surface == engine::not_told) return;
                    ++counts.told;
                    const Silent silent;
                    const Ray<double> ray = pixel_ray(seen, x, y, scene.height);
                    const auto hit = truth.trace(ray, silent);
                    if (surface != (hit ? static_cast<std::uint32_t>(hit->surface) : engine::no_surface)) ++wrong;
                    else if (hit) {
                        ++counts.hits;
                        far_off += !(std::abs(t - hit->t) * length(ray.D) <=
                                     1e-4 * length(ray.P + hit->t * ray.D) + 1e-4 * hit->t * length(ray.D));
                    }
                });
    CHECK(wrong == 0);
    if (pixels_apart) CHECK(far_off == 0);
    return counts;
}

Scene looked_at(Scene scene, const Point& eye, const Point& at, int size) {
    scene.view = PinholeView{eye, at};
    scene.width = scene.height = size;
    return scene;
}

/// Straight down along `direction`, `width` units wide in all.
Scene from_above(Scene scene, const Point& middle, const Point& direction, double width, int size) {
    const Point right = unit(cross(direction, Point{0.1, 0.3, 1})), up = unit(cross(right, direction));
    const double pixel = width / size;
    scene.view =
        ParallelView{middle - width * direction - 0.5 * width * (right + up), pixel * right, pixel * up, direction};
    scene.width = scene.height = size;
    return scene;
}

constexpr int size = 40 / test::share * 2 + 3;  // not a whole number of tiles

}  // namespace

TEST_CASE("meshes at all scales and distances from the origin") {
    Rays rays(1);
    for (const auto& shape : {Shapes::cube(), Shapes::globe(3), Shapes::torus(16, 10), Shapes::fan(24)})
        for (const double away : {0.0, 30.0, 1e4})
            for (const int magnitude : {-10, 0, 10}) {
                const double scale = std::pow(10, magnitude);
                const Shapes::Shape there = test::placed(shape, scale, away, false);
                const Point middle = scale * away * test::odd_direction;
                const std::string name = there.name + " of size 1e" + std::to_string(magnitude);
                const Scene scene = test::scene_of(there);
                const Point eye = middle + 3 * scale * unit(rays.anywhere());
                // A pinhole's plane is at distance 1: that far from the origin doubles can hardly tell its pixels
                // apart.
                const bool apart = (3 + away) * scale <= 1e9;
                const Counts pinhole = check(name, looked_at(scene, eye, middle, size), apart);
                const Counts parallel = check(name, from_above(scene, middle, unit(rays.anywhere()), 3 * scale, size));
                if (!apart) continue;
                for (const Counts& counts : {pinhole, parallel}) {
                    CHECK(counts.hits > counts.pixels / 100);
                    CHECK(counts.told > counts.pixels * 9 / 10);
                }
            }
}

TEST_CASE("along the axes: faces seen edge-on, rays in the faces of boxes") {
    const Scene scene = test::scene_of(Shapes::cube());
    for (const Point& direction : {Point{1, 0, 0}, {0, -1, 0}, {0, 0, 1}})
        check("cube", from_above(scene, {0, 0, 0}, direction, 3, size));
    Scene flat = scene;  // pixels on edges and vertices exactly
    flat.view = ParallelView{{-2, -2, 5}, {0.25, 0, 0}, {0, 0.25, 0}, {0, 0, -1}};
    flat.width = flat.height = 17;
    const Counts counts = check("cube, whole numbers", flat);
    CHECK(counts.told < counts.pixels);  // floats cannot decide the rays on an edge
}

TEST_CASE("from inside, and close by") {
    const Scene scene = test::scene_of(Shapes::globe(3));
    check("inside a globe", looked_at(scene, {0.1, 0.2, 0.3}, {5, 1, 1}, size));
    check("close to a globe", looked_at(scene, {0, 0, 1.001}, {0.5, 0.5, 0.9}, size));
    check("on a globe", looked_at(scene, {1, 0, 0}, {-1, 0.1, 0}, size));
}

TEST_CASE("spheres and triangles that cross, touch and hide each other") {
    Rays rays(2);
    for (int i = 0; i < 40 / test::share; ++i) {
        Scene scene;
        for (int k = 0; k < 20; ++k) {
            scene.spheres.push_back({2.0 * rays.anywhere(), 0.1 + 0.5 * rays.random.fraction(), {}});
            const Point at = 2.0 * rays.anywhere();
            scene.triangles.push_back({{at + rays.anywhere(), at + rays.anywhere(), at + rays.anywhere()}, {}});
            if (k % 5 == 0) scene.triangles.push_back(scene.triangles.back());                // twice the same
            if (k % 7 == 0) scene.triangles.push_back({{at, at, at + rays.anywhere()}, {}});  // no area
            if (k % 6 == 0) scene.spheres.push_back(scene.spheres.back());
        }
        check("a heap", looked_at(scene, 6.0 * unit(rays.anywhere()), {0, 0, 0}, size));
        check("a heap from inside", looked_at(scene, 0.1 * rays.anywhere(), {1, 1, 0}, size));
        check("a heap in parallel", from_above(scene, {0, 0, 0}, rays.anywhere(), 4, size));
        check("from amidst in parallel", from_above(scene, {0, 0, 0}, 0.1 * rays.anywhere(), 4, size));
    }
}

/// A sphere of radius 1 that fills about half of the picture, through a lens that is the longer the farther off it is.
Scene far_ball(double off) {
    Scene scene;
    const Point centre = off * test::odd_direction;
    scene.spheres.push_back({centre, 1, {}});
    Scene seen = looked_at(scene, {0, 0, 0}, centre, size);
    std::get<PinholeView>(seen.view).field_of_view *= 3 / length(centre);
    return seen;
}

// At 1e8 radii, what doubles lose of a sphere's distance is as much as 1e-8 of its radius, and of its squares all of
// the radius.
TEST_CASE("spheres far off") {
    for (const double off : {1e2, 1e4, 1e6, 1e8, 1e9, 1e10}) {
        const Counts counts = check("far off", far_ball(off), false);
        CHECK(counts.hits > counts.pixels / 3);
        CHECK(counts.told > counts.pixels * 9 / 10);
    }
    for (const double off : {1e11, 1e12, 1e13}) check("farther off", far_ball(off), false);
}

TEST_CASE("many spheres in nearly one place, and around the eye") {
    Rays rays(6);
    for (const double apart : {1e-1, 1e-3, 1e-6, 1e-12}) {
        Scene scene;
        for (int k = 0; k < 60; ++k) scene.spheres.push_back({apart * rays.anywhere(), 1, {}});
        const Counts counts = check("crowded", looked_at(scene, {0, -4, 0}, {0, 0, 0}, size));
        if (apart > 1e-5) CHECK(counts.told > counts.pixels * 8 / 10);  // nearer to each other, floats do not tell
        check("crowded, from inside", looked_at(scene, {0.1, 0, 0.2}, {1, 1, 0}, size));
        check("crowded, from the rim", looked_at(scene, {0, 0, 1}, {0.1, 1, 0}, size));
    }
    Scene concentric;
    for (int k = 1; k <= 100; ++k) concentric.spheres.push_back({{0, 0, 0}, 0.01 * k, {}});
    for (const Point& eye : {Point{0, 0, 0}, {0, 0, 0.5}, {0, 0.3, 0.805}, {0, 0, 1}, {0, 0, 5}}) {
        const Counts counts = check("concentric", looked_at(concentric, eye, eye + Point{0.3, -1, -0.1}, size));
        const bool on_a_sphere = eye == Point{0, 0, 0.5} || eye == Point{0, 0, 1};  // which rays then start inside?
        if (!on_a_sphere) CHECK(counts.told > counts.pixels / 2);
    }
}

TEST_CASE("spheres of all sizes, some of them around the eye") {
    Rays rays(7);
    for (int i = 0; i < 60 / test::share; ++i) {
        Scene scene;
        const int span = static_cast<int>(rays.random.below(9));
        const auto any_size = [&] { return std::pow(10, 2 * span * (rays.random.fraction() - 0.5)); };
        for (int k = 0; k < 30; ++k) {
            const Point at = any_size() * rays.anywhere();
            scene.spheres.push_back({at, any_size() * (0.1 + rays.random.fraction()), {}});
            if (k % 3 == 0) scene.triangles.push_back({{at, at + rays.anywhere(), at + rays.anywhere()}, {}});
        }
        check("all sizes", looked_at(scene, any_size() * rays.anywhere(), {0, 0, 0}, size), false);
        check("all sizes in parallel", from_above(scene, {0, 0, 0}, rays.anywhere(), any_size(), size), false);
    }
}

// The ground runs away from a tile's rays, so that all of them have met it before the boxes of the things just before
// its far end are opened.
TEST_CASE("small things just before what is far off") {
    Rays rays(5);
    Scene ground;
    ground.triangles = {{{{{0, -4000, -1}, {4000, 4000, -1}, {0, 4000, -1}}}, {}},
                        {{{{0, -4000, -1}, {4000, -4000, -1}, {4000, 4000, -1}}}, {}}};
    ground.width = ground.height = size;
    Scene parallel = ground, pinhole = ground;
    pinhole.view = PinholeView{{0, 0, 0}, {1, 0, -0.03}, {0, 0, 1}, 3};
    parallel.view = ParallelView{{0, -1, 0}, {0, 2.0 / size, 0}, {0, 0, 40.0 / size}, unit(Point{1, 0, -0.02})};
    for (Scene& scene : {std::ref(pinhole), std::ref(parallel)}) {
        const View seen = view(scene, {});
        for (int i = 0; i < size * size / 8; ++i) {
            const int x = static_cast<int>(rays.random.below(size)), y = static_cast<int>(rays.random.below(size));
            const Ray<double> ray = pixel_ray(seen, x, y, size), next = pixel_ray(seen, x + 1, y, size);
            const double t = -(1 + ray.P.z) / ray.D.z;
            if (!(t > 0 && t < 4000)) continue;
            const double before = t * (1 - rays.random.positive(-20, -6));
            const Point middle = at(ray, before);
            const double radius = 0.4 * length(at(next, before) - middle);
            scene.triangles.push_back({{{middle + radius * rays.anywhere(), middle + radius * rays.anywhere(),
                                         middle + radius * rays.anywhere()}},
                                       {}});
        }
        // Within a tile t grows a hundredfold; in floats it is accurate to the digits of the smallest.
        const Counts counts = check("ground", scene, false);
        CHECK(counts.told > counts.pixels / 2);
    }
}

// The triangle is met first, too near for floats: the tile must give up for good, whatever it meets afterwards.
TEST_CASE("a triangle too small for floats about the eye, before a sphere far off") {
    Scene scene;
    scene.spheres.push_back({{0, 0, -0x1p26}, 0x1p25, {}});
    scene.triangles.push_back({{{{0, 0, -0x1p-530}, {0, -0x1p-528, 0}, {-0x1p-532, 0, 0}}}, {}});
    check("tiny", looked_at(scene, {0, 0, 0}, {0, 0, -1}, 1));
}

TEST_CASE("views that are hardly views") {
    const Scene scene = test::scene_of(Shapes::globe(2));
    Scene odd = from_above(scene, {0, 0, 0}, {0, 0, -1}, 3, size);
    auto& v = std::get<ParallelView>(odd.view);
    v.up = v.right + 1e-9 * v.up;  // nearly one line
    check("skewed", odd);
    v.direction = {0x1p-80, 0, 0};
    check("slow", odd);
    v = ParallelView{{1e30, 0, 0}, {0, 1e28, 0}, {0, 0, 1e28}, {-1, 0, 0}};
    check("vast", odd);
    v = ParallelView{{2, 0, 0}, {0, 1e-30, 0}, {0, 0, 1e-30}, {-1, 0, 0}};
    check("narrow", odd);
    v = ParallelView{{0x1p48, -2, -2}, {0, 4.0 / size, 0}, {0, 0, 4.0 / size}, {-0x1p-49, 0, 0}};
    check("far off and slow", odd);
    v = ParallelView{{2, -2, -2}, {0, 4.0 / size, 0}, {0, 0, 4.0 / size}, {-0x1p49, 0, 0}};
    check("near and fast", odd);
    for (const double away : {0x1p20, 0x1p30, 0x1p40, 0x1p48})
        check("far off", looked_at(scene, {away, 1, 2}, {}, size));
}

TEST_CASE("every kind of vectors that this processor has tells the truth") {
    Rays rays(4);
    Scene heap;
    for (int k = 0; k < 30; ++k) {
        heap.spheres.push_back({2.0 * rays.anywhere(), 0.1 + 0.3 * rays.random.fraction(), {}});
        const Point at = 2.0 * rays.anywhere();
        heap.triangles.push_back({{at + rays.anywhere(), at + rays.anywhere(), at + rays.anywhere()}, {}});
    }
    const Scene scenes[] = {looked_at(heap, {5, 1, 1}, {0, 0, 0}, size),
                            from_above(heap, {0, 0, 0}, {0.1, 0.3, -1}, 4, size),
                            looked_at(test::scene_of(Shapes::globe(4)), {0, -3, 0.5}, {0, 0, 0}, size)};
    test::with_every_kind_of_vectors([&](std::int64_t target) {
        CHECK(std::string(engine::vectors_used()) == hwy::TargetName(target));
        for (const Scene& scene : scenes) {
            const Counts counts = check(engine::vectors_used(), scene);
            CHECK(counts.told > counts.pixels * 9 / 10);
            // Ray by ray, with the same kind of vectors.
            const View seen = view(scene, {});
            const CertifiedSearch truth(surfaces<double>(scene, 5), {}, {}, reach(seen, scene.width, scene.height),
                                        false);
            const FastSearch fast(build_engine(scene, 5, 1), {}, {});
            int wrong = 0;
            for (int y = 0; y < scene.height; y += 3)
                for (int x = 0; x < scene.width; x += 3) {
                    const Silent silent;
                    const Ray<double> ray = pixel_ray(seen, x, y, scene.height);
                    const auto hit = fast.trace(ray, silent), expected = truth.trace(ray, silent);
                    wrong += hit.has_value() != expected.has_value() ||
                             (hit && (hit->surface != expected->surface || hit->t != expected->t));
                }
            CHECK(wrong == 0);
        }
    });
}

// The key is 1/t: about 1e40, which no float holds. Part of the picture meets the near triangle all the same, at about
// t = 1e-40.
TEST_CASE("a plane so near the eye that its key is no float hides what lies behind it") {
    Scene scene;
    scene.triangles.push_back({{Point{0, 0, -1e-40}, Point{1, 0, -1e-40}, Point{0, 1, -1e-40}}, {}});
    scene.triangles.push_back({{Point{-9, -9, -1}, Point{9, -9, -1}, Point{0, 9, -1}}, {}});
    for (const Point& at : {Point{0, 0, -1}, Point{0.1, 0.2, -1}})
        check("near", looked_at(scene, {0, 0, 0}, at, size), false);
    // About the eye, r = t |D|.
    scene.spheres.push_back({{0, 0, 0}, 2e-40, {}});
    scene.spheres.push_back({{0, 0, 0}, 1e-40, {}});
    check("around", looked_at(scene, {0, 0, 0}, {0.1, 0.2, -1}, size), false);
}

// A floor of squares, each cut into two triangles, straight from above, by pixels of side 1: two tiles of 32 × 32, the
// left one first. Squares of side 1 make triangles that cover 1/2 of a pixel; those of side 1/2 cover 1/8, and rays are
// traced one by one where it is less than 0.2 and the tile before tells nothing. The rays keep clear of all edges,
// which lie where x, y or x − y is a multiple of 1/2.
//
// Over a floor of side 1 on the right, 24 layers of triangles at each pixel, which its ray passes beyond their longest
// edge, but within their boxes: 32 · 32 · 24 triangles in 3072 leaves or more, of which a tile tests no more than 2048.
TEST_CASE("where rays come near many more surfaces than they meet, they are left to be traced one by one") {
    constexpr int side = engine::tile_side;
    CHECK(side == 32);
    const Point first{0.6, 0.73, 0};  // where the first pixel's ray goes
    const auto floor = [&](int left_cuts, int layers) {
        Scene scene;
        scene.width = 2 * side;
        scene.height = side;
        for (int y = 0; y <= side; ++y)
            for (int x = 0; x <= 2 * side; ++x) {
                const int cuts = x < side ? left_cuts : 1;
                for (int up = 0; up < cuts; ++up)
                    for (int right = 0; right < cuts; ++right) {
                        const Point a{x + right * 1.0 / cuts, y + up * 1.0 / cuts, 0}, b = a + Point{1.0 / cuts, 0, 0},
                                                                                       c = b + Point{0, 1.0 / cuts, 0},
                                                                                       d = a + Point{0, 1.0 / cuts, 0};
                        scene.triangles.push_back({{a, b, c}, {}});
                        scene.triangles.push_back({{a, c, d}, {}});
                    }
                for (int layer = 0; x >= side && layer < layers; ++layer) {
                    const Point at = first + Point{x - 0.3, y - 0.3, (layer + 1) * 1e-4};
                    scene.triangles.push_back({{at, at + Point{0.4, 0, 0}, at + Point{0, 0.4, 0}}, {}});
                }
            }
        return scene;
    };
    for (const Scene& scene : {floor(2, 0), floor(1, 24)}) {
        Scene parallel = scene, pinhole = scene;
        parallel.view = ParallelView{first + Point{0, 0, 5}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
        // From 16 above, as high as half of the picture: 32 pixels on 32 units.
        const Point middle = first + Point{side - 0.5, side / 2 - 0.5, 0};
        pinhole.view = PinholeView{middle + Point{0, 0, 16}, middle, {0, 1, 0}, 90};
        for (const Scene& one : {parallel, pinhole}) {
            const Counts counts = check("a floor", one);
            CHECK(counts.pixels == 2 * side * side);
            CHECK(counts.told == side * side);
            CHECK(counts.hits == side * side);
        }
    }
}

// D = (0, 0, −2) has length 2. A pixel of the plane is 3 · 0.5 = 1.5 large, at t = 4 of a pinhole's ray 4² times that.
// A triangle of area 2 in the plane z = 0 is seen as it is, one in the plane x = z at 45°, from its side as nothing.
TEST_CASE("how large pixels and surfaces look along a ray") {
    const ViewingPlane<double> plane{{0, 0, 0}, {3, 0, 0}, {0, 0.5, 0}};
    const Point D{0, 0, -2};
    CHECK(pixel_area(Parallel<double>{plane, {0, 0, -1}}, D, 4) == 2 * 1.5);
    CHECK(pixel_area(FromEye{plane, {}}, D, 4) == 2 * 16 * 1.5);
    CHECK(seen_area(Triangle<double>{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, D) == 2 * 2);
    CHECK(seen_area(Triangle<double>{{0, 0, 0}, {2, 0, 2}, {0, 2, 0}}, D) == 2 * 2);
    CHECK(seen_area(Triangle<double>{{0, 0, 0}, {0, 0, 2}, {0, 2, 0}}, D) == 0);
    CHECK(seen_area(Sphere<double>{{1, 2, 3}, 0.5}, D) == doctest::Approx(2 * 3.14159265 * 0.25));
}
