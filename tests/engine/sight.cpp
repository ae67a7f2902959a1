// Sight against exact arithmetic: its bounds hold for all points, and true rays are where it takes them to be.
#include "engine/sight.hpp"

#include <doctest.h>

#include <optional>

#include "bounds_against_exact.hpp"
#include "render/tiles.hpp"

using namespace glassbox;
using test::exact;
using test::is_less;

namespace {

/// y = tD + right R + up U. By Cramer's rule t = y·(R × U)/V, right = y·(U × D)/V, up = y·(D × R)/V, where
/// V = D·(R × U).
struct Place {
    Exact t, right, up;
};

Place place(const Vec3<Exact>& y, const Vec3<Exact>& D, const Vec3<Exact>& R, const Vec3<Exact>& U) {
    const Vec3<Exact> n = cross(R, U);
    const Exact V = dot(D, n);
    return {dot(y, n) / V, dot(y, cross(U, D)) / V, dot(y, cross(D, R)) / V};
}

/// Whether the number is between the bounds at x, as floats compute them: each product and sum rounded once, or twice.
bool is_between(const engine::Bounds& bounds, const float (&x)[3], const Exact& number) {
    float low = bounds.low, high = bounds.high, fused_low = low, fused_high = high;
    for (int k = 0; k < 3; ++k) {
        low = bounds.w[k] * x[k] + low;
        high = bounds.w[k] * x[k] + high;
        fused_low = std::fma(bounds.w[k], x[k], fused_low);
        fused_high = std::fma(bounds.w[k], x[k], fused_high);
    }
    const Exact least(double{std::max(low, fused_low)}), most(double{std::min(high, fused_high)});
    return !is_less(number, least) && !is_less(most, number);
}

struct SightCounts {
    int tried = 0, seen = 0, wrong = 0;
};

/// The bounds of a tile's sight at points of the engine's box, its corners among them.
void check_bounds(SightCounts& counts, const engine::Engine& engine, const engine::Grid& grid,
                  const engine::MiddleRay& middle, test::Doubles& random) {
    ++counts.tried;
    const std::optional<engine::Sight> seen = engine::sight(engine, grid, middle);
    if (!seen) return;
    ++counts.seen;
    const float reach = engine.around().reach();
    for (int n = 0; n < 20; ++n) {
        float x[3];
        for (float& coordinate : x)
            coordinate = random.one_in(3) ? static_cast<float>(random.sign()) * reach
                                          : static_cast<float>(2 * random.fraction() - 1) * reach;
        const Vec3<Exact> y = exact(Vec3<double>{x[0], x[1], x[2]}) - exact(middle.P);
        const Place at = place(y, exact(middle.D), exact(grid.right), exact(grid.up));
        counts.wrong +=
            !is_between(seen->t, x, at.t) || !is_between(seen->right, x, at.right) || !is_between(seen->up, x, at.up);
    }
}

/// Three vectors of these sizes that span space, more or less.
void check_bounds(SightCounts& counts, double size, double away, double pixel, double speed, test::Doubles& random) {
    const engine::Engine engine = test::engine_of_size({}, size);
    engine::Grid grid;
    grid.pinhole = random.one_in(2);
    grid.right = test::some_vector(random, pixel);
    grid.up = test::some_vector(random, pixel);
    check_bounds(counts, engine, grid, {test::some_vector(random, away), test::some_vector(random, speed)}, random);
}

bool is_near(const Exact& a, double b, double distance) { return compare(abs(a - Exact(b)), Exact(distance)) <= 0; }

constexpr double half = (engine::tile_side - 1) * 0.5;

/// The ray in the middle of the tile that begins at this column and row.
Ray<double> middle_ray(const engine::Grid& grid, int column, int row) {
    const Vec3<double> at = grid.corner + (column + half) * grid.right + (row + half) * grid.up;
    return grid.pinhole ? Ray<double>{grid.eye, at} : Ray<double>{at, grid.direction};
}

/// Each of a tile's true rays, as they are traced one by one, is where the tile takes it to be: dj and di pixels from
/// its middle ray, but for its off_by; and in a pinhole's view its t are the tile's, but for 2⁻²² of them.
void check_rays(SightCounts& counts, const engine::Engine& engine, const View& view, int width, int height, int column,
                int row) {
    ++counts.tried;
    const std::optional<engine::Grid> grid = grid_for(view, width, height, engine);
    if (!grid) return;
    const auto [start, D] = middle_ray(*grid, column, row);
    const std::optional<engine::Sight> seen = engine::sight(engine, *grid, {start - engine.middle(), D});
    if (!seen) return;
    ++counts.seen;
    for (int i = 0; i < engine::tile_side; ++i)
        for (int j = 0; j < engine::tile_side; ++j) {
            const Ray<double> ray = pixel_ray(view, column + j, height - 1 - (row + i), height);
            // What is linear in the way from `start`: the ray's point at the grid's t = 1, where it is D itself from an
            // eye. The grid is at the engine's scale s, and its t is t_scale times the ray's: there it is s(P +
            // D/t_scale).
            const Exact s(engine.scale()), of_D(engine.scale() / grid->t_scale);
            const Vec3<Exact> y = s * exact(ray.P) + of_D * exact(ray.D) - exact(start);
            const Place found = place(y, exact(D), exact(grid->right), exact(grid->up));
            const Exact dj = grid->pinhole ? found.right / found.t : found.right;
            const Exact di = grid->pinhole ? found.up / found.t : found.up;
            counts.wrong += !is_near(dj, j - half, seen->off_by) || !is_near(di, i - half, seen->off_by) ||
                            (grid->pinhole && !is_near(found.t, 1, 0x1p-22));
        }
}

}  // namespace

TEST_CASE("sight: t and the pixel of every point are between its bounds") {
    test::Doubles random(11);
    SightCounts counts;
    for (int i = 0; i < 1500; ++i) {
        const double size = test::power_of_ten(random, -12, 12), pixel = test::power_of_ten(random, -12, 12);
        const double away = size * (random.one_in(3) ? 0 : random.positive(-10, 20));
        check_bounds(counts, size, away, pixel, test::power_of_ten(random, -12, 12), random);
    }
    CHECK(counts.wrong == 0);
    CHECK(counts.seen > counts.tried / 4);
}

// A grid's ray_error is at least 12u of the numbers that its rays are made of: where a product of pixels could
// underflow, it alone moves rays by more than most_off_by, and there is no sight.
TEST_CASE("sight: views of all magnitudes give none, or one whose bounds hold") {
    test::Doubles random(12);
    SightCounts counts;
    for (int i = 0; i < 3000; ++i) {
        const engine::Engine engine = test::engine_of_size({}, test::magnitude(random));
        const double pixel = test::magnitude(random);
        const ViewingPlane<double> plane{test::some_vector(random, test::magnitude(random)),
                                         test::some_vector(random, pixel), test::some_vector(random, pixel)};
        const Vec3<double> other = test::some_vector(random, test::magnitude(random));
        const View view = random.one_in(2) ? View(FromEye{plane, other}) : View(Parallel<double>{plane, other});
        const std::optional<engine::Grid> grid = grid_for(view, engine::tile_side, engine::tile_side, engine);
        if (!grid) continue;
        const Ray<double> middle = middle_ray(*grid, 0, 0);
        check_bounds(counts, engine, *grid, {middle.P - engine.middle(), middle.D}, random);
    }
    CHECK(counts.wrong == 0);
    CHECK(counts.seen > 0);
}

TEST_CASE("sight: a tile's true rays are where it takes them to be") {
    test::Doubles random(13);
    SightCounts counts;
    for (int n = 0; n < 150; ++n) {
        const double size = test::power_of_ten(random, -12, 12);
        const double away = random.one_in(2) ? 0 : random.positive(-10, 30);  // in sizes
        const engine::Engine engine = test::engine_of_size({}, size);
        const Vec3<double> eye = size * (test::some_vector(random, away) + Vec3<double>{0.5, -0.25, 4});
        // A picture of 640 × 480 pixels, which is as wide as what is seen, or up to a thousandth of it.
        const double width = size * random.positive(-10, 1), pixel = width / 640;
        ViewingPlane<double> plane;
        plane.right = {pixel, 0.1 * pixel * random.fraction(), 0};
        plane.up = {0, pixel, 0.1 * pixel * random.fraction()};
        const Vec3<double> to_corner = -320.0 * plane.right - 240.0 * plane.up - Vec3<double>{0, 0, size};
        const int column = static_cast<int>(random.below(640 / 8)) * 8, row = static_cast<int>(random.below(60)) * 8;
        FromEye from_eye;
        from_eye.plane = plane;
        from_eye.plane.corner = to_corner;
        from_eye.eye = eye;
        check_rays(counts, engine, from_eye, 640, 480, column, row);
        Parallel<double> parallel;
        parallel.plane = plane;
        parallel.plane.corner = eye + to_corner;
        parallel.direction = {0.1 * random.fraction(), 0.2 * random.fraction(), -random.positive(-20, 20)};
        check_rays(counts, engine, parallel, 640, 480, column, row);
    }
    CHECK(counts.wrong == 0);
    CHECK(counts.seen > counts.tried / 2);
}
