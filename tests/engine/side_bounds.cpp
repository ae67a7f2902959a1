// Bounds of side products for a patch of rays: what they say of each triangle holds for every ray in it, at any
// magnitude, in doubles and in floats.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <magnitude.hpp>
#include <sides.hpp>

#include "bounds_against_exact.hpp"
#include "engine/side_bounds.hpp"
#include "every_kind_of_vectors.hpp"
#include "numerics/as_float.hpp"

using namespace glassbox;
using test::power_of_ten;
using test::some_vector;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Numbers {
    double least_side, certainty;
};

/// The numbers that are bounded, as a scalar computes them: of the certainty's definition see
/// TriangleNumbers::certainty. NaN where there are none.
template <class Real>
Numbers numbers_of(const Ray<double>& given, const Triangle<double>& triangle) {
    const Ray<Real> ray = convert<Real>(given);
    const Triangle<Real> seen = seen_from(ray.P, convert<Real>(triangle));
    const Sides<double> s = [&] {
        const Sides<Real> in_scalar = sides(ray.D, seen);
        return Sides<double>{in_scalar.a, in_scalar.b, in_scalar.c};
    }();
    const Sides<Magnitude> S = sides(convert<Magnitude>(ray.D), convert<Magnitude>(seen));
    const double a = s.a / S.a.size, b = s.b / S.b.size, c = s.c / S.c.size;
    const double least = std::min({a, b, c}), greatest = std::max({a, b, c});
    const double sizes = std::min({std::abs(a), std::abs(b), std::abs(c)});
    return {std::min({std::abs(s.a), std::abs(s.b), std::abs(s.c)}),
            least < 0 && greatest > 0 ? std::min(-least, greatest) : sizes};
}

/// A patch of rays from one point, or of one direction, about triangles of that size.
engine::RayPatch some_patch(test::Doubles& random, double size, double speed, bool in_floats) {
    engine::RayPatch patch{some_vector(random, 4 * size), some_vector(random, speed)};
    const double wide = random.positive(-20, -1);
    // Floats to start with: the scalar does not round the start, and the direction as the patch's rounding has it.
    if (in_floats) patch.P = as_float(patch.P);
    if (random.one_in(2)) {
        patch.D_right = wide * some_vector(random, speed);
        patch.D_up = wide * some_vector(random, speed);
    } else {
        patch.P_right = wide * some_vector(random, size);
        patch.P_up = wide * some_vector(random, size);
    }
    patch.rounding = in_floats ? engine::rounding_of_floats : engine::rounding_of_doubles;
    const bool start_is_known = patch.P_right == Vec3<double>{} && patch.P_up == Vec3<double>{};
    // Coordinates of P are at most 5 size: rounded to the scalar, and 16 units for the bounds.
    patch.P_error = start_is_known ? 0 : 128 * (in_floats ? 0x1p-24 : 0x1p-53) * size;
    patch.D_error = 64 * 0x1p-53 * speed + (in_floats ? 0x1p-149 : 0x1p-1074);
    return patch;
}

struct Counts {
    int wrong = 0, bounded = 0, passed_over = 0, all = 0;
};

template <class Real>
void check_patch(Counts& counts, double size, double speed, test::Doubles& random) {
    constexpr bool in_floats = std::is_same_v<Real, float>;
    const engine::RayPatch patch = some_patch(random, size, speed, in_floats);
    const auto ray_at = [&](double x, double y) {
        return Ray<double>{patch.P + x * patch.P_right + y * patch.P_up, patch.D + x * patch.D_right + y * patch.D_up};
    };
    const Ray<double> near_edges = ray_at(random.fraction(), random.fraction());
    std::vector<Triangle<double>> triangles;
    for (std::uint64_t i = 0; i <= random.below(20); ++i) {
        const Vec3<double> A = some_vector(random, size);
        Vec3<double> B = A + random.positive(-9, 0) * some_vector(random, size);
        const Vec3<double> C = random.one_in(20) ? B : A + random.positive(-9, 0) * some_vector(random, size);
        if (random.one_in(3)) B = 2.0 * at(near_edges, random.fraction() * size / speed) - A;
        triangles.push_back(in_floats ? as_float(Triangle<double>{A, B, C}) : Triangle<double>{A, B, C});
    }
    const std::vector<engine::EightTriangles> blocks = engine::in_blocks(triangles);
    std::vector<double> sides_at_least, certainties_at_least;
    const double side_at_most = engine::least_sides(patch, blocks, sides_at_least);
    const double certainty_at_most = engine::least_certainties(patch, blocks, certainties_at_least);
    counts.bounded += certainty_at_most < infinity;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        ++counts.all;
        counts.passed_over += certainties_at_least[i] > certainty_at_most;
    }
    for (int n = 0; n < 10; ++n) {
        const auto place = [&] { return random.one_in(3) ? random.sign() : 2 * random.fraction() - 1; };
        const double x = place(), y = place();
        const Ray<double> ray = n == 0 ? near_edges : ray_at(x, y);
        double least_side = infinity, least_certainty = infinity;
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const auto [its_side, its_certainty] = numbers_of<Real>(ray, triangles[i]);
            counts.wrong += its_side < sides_at_least[i];
            // S is rounded in one and the other, and where it underflows is left out.
            counts.wrong += its_certainty * (1 + 0x1p-20) < certainties_at_least[i];
            least_side = std::fmin(least_side, its_side);
            least_certainty = std::fmin(least_certainty, its_certainty);
        }
        counts.wrong += least_side > side_at_most;
        counts.wrong += least_certainty > certainty_at_most * (1 + 0x1p-20);
    }
}

/// From 10 to the one to 10 to the other.
struct Magnitudes {
    int least, most;
};

/// Patches half of which have ordinary sizes and speeds, and half any of the scalar's. At least so many of 5000 must be
/// bounded, and one in so many triangles be passed over.
template <class Real>
void check_patches(std::uint64_t seed, Magnitudes ordinary, Magnitudes any, int bounded, int one_in) {
    test::Doubles random(seed);
    test::with_every_kind_of_vectors([&](std::int64_t target) {
        CAPTURE(hwy::TargetName(target));
        Counts counts;
        for (int n = 0; n < 5000; ++n) {
            const Magnitudes& of = random.one_in(2) ? ordinary : any;
            const double size = power_of_ten(random, of.least, of.most);
            const double speed = power_of_ten(random, of.least, of.most);
            check_patch<Real>(counts, size, speed, random);
        }
        CHECK(counts.wrong == 0);
        CHECK(counts.bounded > bounded);
        CHECK(one_in * counts.passed_over > counts.all);
    });
}

}  // namespace

// They are of use: half of the patches have ordinary numbers, and few of a patch's triangles are its least.
TEST_CASE("bounds of side products hold for every ray of a patch, in doubles of all sizes") {
    check_patches<double>(11, {-6, 6}, {-300, 300}, 2000, 4);
}

TEST_CASE("bounds of side products hold for floats, too") { check_patches<float>(12, {-3, 5}, {-40, 40}, 1500, 5); }

TEST_CASE("a patch's triangles up to a limit are kept in their order, with their numbers") {
    std::vector<Triangle<double>> triangles;
    std::vector<double> numbers;
    for (int i = 0; i < 19; ++i) {
        triangles.push_back({{1.0 * i, 0, 0}, {0, 1, 0}, {0, 0, 1}});
        numbers.push_back(i % 3);
    }
    const std::vector<engine::EightTriangles> blocks = engine::in_blocks(triangles);
    REQUIRE(blocks.size() == 3);
    CHECK(blocks[2].count == 3);
    // Numbers of the places that are left over do not count.
    numbers.resize(24, 0);
    std::vector<engine::EightTriangles> kept;
    engine::keep_up_to(0.5, blocks, numbers, kept);
    REQUIRE(kept.size() == 1);
    CHECK(kept[0].count == 7);  // 0, 3, … 18
    for (std::uint32_t at = 0; at < 7; ++at) {
        CHECK(kept[0].surface[at] == 3 * at);
        CHECK(kept[0].triangle(at).A.x == 3 * at);
    }
    CHECK(kept[0].A[0][7] == 18);  // repeats the last
    engine::keep_up_to(-1, blocks, numbers, kept);
    CHECK(kept.empty());
}
