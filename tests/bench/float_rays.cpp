// The rays of the benchmarks: floats exactly, in an order as renderers have them; and what checks their answers.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "../certified/cases.hpp"
#include "bench/float_rays.hpp"
#include "bench/meshes.hpp"
#include "bench/plain_loop.hpp"
#include "bench/trace_certified.hpp"
#include "engine/tile.hpp"
#include "numerics/as_float.hpp"
#include "render/search/build_engine.hpp"
#include "render/search/certified_search.hpp"

using namespace glassbox;

namespace {

Scene knot(int side) {
    Scene scene = seen(trefoil(16, 6), {0, 0, 4}, {0, 0.1, 0});  // 16 · 6 · 2 = 192 triangles
    scene.width = scene.height = side;
    return scene;
}

bool are_floats(const Vec3<double>& v) { return as_float(v) == v; }

}  // namespace

TEST_CASE("every pixel's ray is made of floats, and runs nearly as the scene's view has it") {
    const Scene scene = knot(1024);
    const FromEye coarse = view_in_floats(scene);
    const View exact = view(scene, {});
    int off = 0;
    for (int y = 0; y < 1024; y += 31)
        for (int x = 0; x < 1024; x += 31) {
            const Ray<double> ray = pixel_ray(View(coarse), x, y, 1024), wanted = pixel_ray(exact, x, y, 1024);
            const Vec3<double> apart = ray.D - wanted.D;
            // corner, right and up are each off by 2⁻²⁴ at most, the last two times 1,023: in all by less than 2⁻¹²
            off += !are_floats(ray.P) || !are_floats(ray.D) || std::sqrt(dot(apart, apart)) > 2 * 0x1p-12;
        }
    CHECK(off == 0);
}

TEST_CASE("the vertices of all meshes are floats, as Embree is given them") {
    for (const Mesh& mesh : {trefoil(16, 6), icosphere(2), terrain(8)})
        CHECK(std::ranges::all_of(mesh.vertices, are_floats));
}

TEST_CASE("each 16 rays of the list are 4 x 4 pixels, and each pixel has one") {
    // Morton order: the bits of x and y in turn, x first. (3, 3) is the last of the first 16, (4, 0) the next.
    CHECK(place_of_pixel(0, 0) == 0);
    CHECK(place_of_pixel(1, 0) == 1);
    CHECK(place_of_pixel(0, 1) == 2);
    CHECK(place_of_pixel(3, 3) == 15);
    CHECK(place_of_pixel(4, 0) == 16);
    CHECK(place_of_pixel(1023, 1023) == 1024 * 1024 - 1);
    const FromEye view = view_in_floats(knot(32));
    const std::vector<Ray<float>> rays = camera_rays(view, 32);
    REQUIRE(rays.size() == 32 * 32);
    CHECK(convert<double>(rays[place_of_pixel(5, 9)].D) == pixel_ray(View(view), 5, 9, 32).D);
}

TEST_CASE("rays from the surfaces start where camera rays end, a little off, on their side") {
    const Scene scene = knot(64);
    const std::vector<Ray<float>> camera = camera_rays(view_in_floats(scene), 64);
    std::vector<Ray<double>> rays;
    for (const Ray<float>& ray : camera) rays.push_back(convert<double>(ray));
    const std::vector<std::uint32_t> met = nearest_by_plain_loop(scene, rays, {1, {}, nullptr});
    const auto [ways, lit] = rays_from_surfaces(scene, camera, met, {0, 0, 1});
    const auto hits =
        static_cast<std::size_t>(std::count_if(met.begin(), met.end(), [](auto m) { return m != engine::no_surface; }));
    REQUIRE(hits > 100);
    CHECK(ways.size() == hits);
    CHECK(lit.size() == hits);
    // From a start on the camera's side, back along the camera's ray nothing is in the way.
    std::vector<Ray<double>> back;
    for (const Ray<float>& ray : lit)
        back.push_back({convert<double>(ray.P), Vec3<double>{0, 0, 4} - convert<double>(ray.P)});
    const std::vector<std::uint32_t> in_the_way = nearest_by_plain_loop(scene, back, {1, {}, nullptr});
    // Grazing starts may lie a little behind a neighbouring face's edge: few do.
    const auto blocked =
        std::count_if(in_the_way.begin(), in_the_way.end(), [](auto m) { return m != engine::no_surface; });
    CHECK(static_cast<std::size_t>(blocked) * 50 < hits);
    // The directions are spread evenly over the sphere: their mean is nearly 0.
    Vec3<double> sum{};
    for (const Ray<float>& ray : ways) sum = sum + convert<double>(ray.D);
    CHECK(std::sqrt(dot(sum, sum)) < 4 * std::sqrt(static_cast<double>(ways.size())));
}

TEST_CASE("the loop that checks, surfaces and rays in blocks, answers as the plain search and the engine do") {
    Scene scene = knot(32);
    scene.spheres.push_back({{0.5, 0, 0}, 0.5, {}});
    const FromEye view = view_in_floats(scene);
    const std::vector<Ray<float>> camera = camera_rays(view, 32);
    std::vector<Ray<double>> rays;
    for (const Ray<float>& ray : camera) rays.push_back(convert<double>(ray));
    const std::vector<std::uint32_t> met = nearest_by_plain_loop(scene, rays, {1, {}, nullptr});
    const CertifiedSearch plain(surfaces<double>(scene, 5), {}, {}, reach(view, 32, 32), false);
    const Job job{1, {}, nullptr, build_engine(scene, 5)};
    NearestHits alone(rays.size()), tiles(rays.size());
    trace_certified(camera, job, alone);
    trace_certified(view, 32, 32, job, tiles);
    std::vector<std::uint8_t> occluded(rays.size());
    occluded_certified(camera, job, occluded);
    int different = 0;
    for (std::uint32_t y = 0; y < 32; ++y)
        for (std::uint32_t x = 0; x < 32; ++x) {
            const std::uint32_t place = place_of_pixel(x, y);
            const Silent silent;
            const auto hit = plain.trace(rays[place], silent);
            const std::uint32_t expected = hit ? static_cast<std::uint32_t>(hit->surface) : engine::no_surface;
            different += met[place] != expected || alone.surface[place] != expected ||
                         tiles.surface[y * 32 + x] != expected || (occluded[place] != 0) != hit.has_value();
        }
    CHECK(different == 0);
}

// Surfaces and rays together at all magnitudes, where squares of lengths underflow and overflow; rays at corners, where
// a surface is met or missed by an ulp.
TEST_CASE("the loop that checks passes over no surface that a ray meets, at whatever scale") {
    test::Rays rays(7);
    for (const int exponent : {-990, -700, -530, -400, -250, -60, 0, 60, 250, 400, 500}) {
        CAPTURE(exponent);
        const double scale = std::ldexp(1.0, exponent);
        Scene scene;
        for (int i = 0; i < 12; ++i) {
            const auto anywhere = [&] { return scale * rays.anywhere(); };
            scene.triangles.push_back({{anywhere(), anywhere(), anywhere()}, {}});
            scene.spheres.push_back({anywhere(), scale * 0.2 * (1 + rays.random.fraction()), {}});
        }
        std::vector<Ray<double>> list;
        const Surfaces<double> shapes = surfaces<double>(scene, 5);
        for (const Triangle<double>& triangle : shapes.triangles)
            for (const Vec3<double>& corner : {triangle.A, triangle.B, triangle.C})
                list.push_back(rays.towards(corner, scale));
        for (const Sphere<double>& sphere : shapes.spheres) list.push_back(rays.towards(sphere.C, sphere.r));
        const std::vector<std::uint32_t> met = nearest_by_plain_loop(scene, list, {1, {}, nullptr});
        const CertifiedSearch plain(shapes, {}, {}, reach_of(list), false);
        const Silent silent;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const auto hit = plain.trace(list[i], silent);
            CHECK(met[i] == (hit ? static_cast<std::uint32_t>(hit->surface) : engine::no_surface));
        }
    }
}

// The ray runs along x, and D² = 1e-340 underflows. It meets the sphere, whose middle it passes at 5e24, less than r.
TEST_CASE("the loop that checks passes over nothing where a direction's square underflows") {
    Scene scene;
    scene.spheres.push_back({{1e25, 5e24, 0}, 9e24, {}});
    const std::vector<Ray<double>> rays{{{0, 0, 0}, {1e-170, 0, 0}}};
    CHECK(nearest_by_plain_loop(scene, rays, {1, {}, nullptr})[0] == 0);
}
