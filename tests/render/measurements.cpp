// What `measure` writes, at pixels whose numbers can be worked out by hand.
#include "render/measure/measurements.hpp"

#include <doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "numerics/bits_lost.hpp"
#include "render/measure/triangle_numbers.hpp"
#include "render/render.hpp"
#include "scene/scene_file.hpp"
#include "support/ulps.hpp"

using namespace glassbox;

namespace {

/// All components of one measurement at pixel (x, y).
std::vector<double> measured(const Scene& scene, const char* name, int x, int y, const Options& options = {}) {
    const Measurement* const wanted = find_measurement(name);
    REQUIRE(wanted != nullptr);
    const auto channels = measure(scene, options, {&wanted, 1});
    std::vector<double> values;
    for (const Channel& plane : channels[0])
        values.push_back(plane.values[static_cast<std::size_t>(y) * 500 + static_cast<std::size_t>(x)]);
    return values;
}

double value(const Scene& scene, const char* name, int x, int y, const Options& options = {}) {
    return measured(scene, name, x, y, options).at(0);
}

const Scene paper = read_scene(SCENES "/levental-2014.toml");

// The green sphere's middle: column 350, row 350, so y = 499 − 350. The ray starts at x = 500, the sphere at 100 + 50.
constexpr int gx = 350, gy = 149;
// A pixel that meets nothing.
constexpr int nx = 50, ny = 450;

}  // namespace

TEST_CASE("counts: every pixel is tested against all six surfaces; the ray meets what lies in its way") {
    CHECK(value(paper, "tests", gx, gy) == 6);
    CHECK(value(paper, "tests", nx, ny) == 6);
    CHECK(value(paper, "hits", nx, ny) == 0);
    CHECK(value(paper, "hits", gx, gy) == 1);
    // Inside the tetrahedron's outline: one front face and the back face PQR; the face PQS is seen edge-on.
    CHECK(value(paper, "hits", 370, 499 - 110) == 2);
    Options spheres_only;
    spheres_only.stage = 2;
    CHECK(value(paper, "tests", gx, gy, spheres_only) == 2);
    Options rays_only;
    rays_only.stage = 1;
    CHECK(value(paper, "tests", gx, gy, rays_only) == 0);
}

TEST_CASE("geometry at the green sphere's middle") {
    CHECK_ULPS(value(paper, "depth", gx, gy), 350.0, 0);  // from x = 500 to x = 150
    const auto n = measured(paper, "normal", gx, gy);
    CHECK(n == std::vector<double>{1, 0, 0});
    // (v·D)² − D²(v² − r²) = 400² − (400² − 50²)
    CHECK_ULPS(value(paper, "discriminant", gx, gy), 2500.0, 0);
    CHECK(std::isnan(value(paper, "depth", nx, ny)));
    CHECK(std::isnan(value(paper, "normal", nx, ny)));
}

TEST_CASE("shading at the green sphere's middle") {
    // n = (1,0,0), l = (4,1,1)/√18, r = (1,0,0); h = (1001,250,250)/|…| as the paper's program has it.
    CHECK_ULPS(value(paper, "n.l", gx, gy), 4 / std::sqrt(18.0), 2);
    CHECK_ULPS(value(paper, "n.r", gx, gy), 1.0, 0);
    CHECK_ULPS(value(paper, "n.v", gx, gy), 1.0, 0);  // its name until now
    const double n_h = 1001 / std::sqrt(1001.0 * 1001 + 2 * 250.0 * 250);
    CHECK_ULPS(value(paper, "n.h", gx, gy), n_h, 2);
    CHECK_ULPS(value(paper, "ambient", gx, gy), 0.2, 0);
    CHECK_ULPS(value(paper, "diffuse", gx, gy), 4 / std::sqrt(18.0), 2);
    CHECK_ULPS(value(paper, "specular", gx, gy), 0.2 * std::pow(n_h, 15), 20);
    Options flat;
    flat.stage = 3;
    CHECK(std::isnan(value(paper, "n.l", gx, gy, flat)));
    CHECK_FALSE(std::isnan(value(paper, "depth", gx, gy, flat)));
}

TEST_CASE("side: the smallest side product over the sum of its terms' sizes") {
    Scene scene;
    scene.triangles = {{{Vec3<double>{0, 0, 0}, {0, 100, 0}, {0, 0, 100}}, {255, 255, 255}}};
    // The ray of column 10, row 20 starts at (500, 10, 20) and runs along (-1,0,0). Seen from there A = (-500,-10,-20),
    // B = (-500,90,-20), C = (-500,-10,80). Along D only the x of B × A counts, A.z B.y − A.y B.z and so on:
    //   c: the edge AB at z = 0: B.y A.z − B.z A.y = 90·(−20) − (−20)(−10) = −2000; times D.x = −1: 2000
    //   b: the edge CA at y = 0: A.y C.z − A.z C.y = (−10)(80) − (−20)(−10) = −1000; times −1: 1000
    //   a: the edge BC: C.y B.z − C.z B.y = (−10)(−20) − 80·90 = −7000; times −1: 7000
    // The smallest is b. The sizes of its terms: |D.x|(800 + 200) = 1000, and D.y = D.z = 0 add nothing.
    CHECK_ULPS(value(scene, "side", 10, 499 - 20), 1.0, 0);
    // Column 0 lies on the edge CA.
    CHECK(value(scene, "side", 0, 499 - 20) == 0);
    // Outside, at column 95, row 20: B.y = 5, A.y = C.y = −95, A.z = B.z = −20, C.z = 80.
    //   a: −(C.y B.z − C.z B.y) = −((−95)(−20) − 80·5) = −1500, sizes 1900 + 400 = 2300; |b| = 9500, |c| = 2000.
    CHECK_ULPS(value(scene, "side", 95, 499 - 20), -1500.0 / 2300, 1);
}

namespace {

/// One triangle of size 1, seen from above: column j, row i of a picture of 500 x 500 starts at (j/100 − 2, i/100 − 2,
/// 1).
Scene unit_triangle() {
    Scene scene;
    scene.view = ParallelView{{-2, -2, 1}, {0.01, 0, 0}, {0, 0.01, 0}, {0, 0, -1}};
    scene.triangles = {{{Vec3<double>{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {255, 255, 255}}};
    return scene;
}

std::size_t pixels_with(double wanted_value, const Scene& scene, const char* name, const Options& options) {
    const Measurement* const wanted = find_measurement(name);
    const auto channels = measure(scene, options, {&wanted, 1});
    const auto& values = channels[0][0].values;
    return static_cast<std::size_t>(std::count(values.begin(), values.end(), wanted_value));
}

}  // namespace

TEST_CASE("deficit: twice the smaller of the positive and the negative part") {
    // The ray down from (2, 2, 1) has the weights a = 1 − 2 − 2 = −3, b = 2, c = 2 (times −1, the sign of D·N): their
    // sum is 1 and their sizes' 7, so the difference is 6. 2·min(4, 3) = 6.
    CHECK_ULPS(value(unit_triangle(), "deficit", 400, 99), std::log10(6.0), 1);
}

TEST_CASE("verdict: on a triangle of size 1 the tolerance of 10 hits nearly everywhere, and a proof nowhere wrongly") {
    Options options;
    options.triangle_rule = Tolerance{};
    // What it takes for a hit has 2·min(…) < 10, which all rays of this picture have but those in the farthest corner.
    CHECK(pixels_with(1, unit_triangle(), "verdict", options) > 200000);
    CHECK(pixels_with(2, unit_triangle(), "verdict", options) == 0);
    for (const Scalar proven : {Scalar::certified, Scalar::exact}) {
        options = {};
        options.scalar = proven;
        Scene scene = unit_triangle();
        if (proven == Scalar::exact) scene.width = scene.height = 60;  // exact arithmetic at every pixel takes a while
        const auto all = static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height);
        CHECK(pixels_with(0, scene, "verdict", options) == all);
    }
}

TEST_CASE("margin, undecided and identity on the paper's scene, where every number is whole") {
    Options options;
    options.scalar = Scalar::certified;
    // Column 360, row 120 looks at the edge PR, from (350, 100) to (375, 150), that the faces PQR and PSR share.
    CHECK(value(paper, "undecided", 360, 499 - 120, options) == 2);
    // The two side products of that edge are exactly 0, of whole numbers, and known to be.
    CHECK(value(paper, "margin", 360, 499 - 120, options) == std::numeric_limits<double>::infinity());
    // The face PQS lies in the plane z = 100 and is seen edge-on from all of its row: three zeros.
    CHECK(value(paper, "margin", nx, 499 - 100, options) == std::numeric_limits<double>::infinity());
    CHECK(value(paper, "undecided", nx, ny, options) == 0);
    CHECK(value(paper, "margin", nx, ny, options) > 10);  // whole numbers under 2^30, and bounds of 2^-50 of them
    CHECK(value(paper, "identity", nx, ny, options) == 0);
    options.scalar = Scalar::double_;
    CHECK(std::isnan(value(paper, "undecided", nx, ny, options)));  // plain double does not know
}

TEST_CASE("margin: a side product that came out as 0 is known to be 0 only where it is") {
    // A ray along −z at (x, 0.3) and a triangle whose edge from (x0, 0) to (x0, 1) it passes: with x = x0 the product
    // is exactly 0. In float 0.1 and 0.1 + 2^-40 are one number: there the side product is 0 of the numbers as float
    // has them. In double it is not 0, and not computed as 0.
    Scene scene;
    scene.width = scene.height = 1;
    const auto at = [&](double x, double x0, Scalar scalar) {
        scene.view = ParallelView{{x, 0.25, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
        scene.triangles = {{{Vec3<double>{x0, 0, 0}, {x0 + 1, 0, 0}, {x0, 1, 0}}, {1, 2, 3}}};
        Options options;
        options.scalar = scalar;
        const Measurement* const wanted = find_measurement("margin");
        return measure(scene, options, {&wanted, 1})[0][0].values[0];
    };
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const Scalar scalar : {Scalar::float_, Scalar::double_, Scalar::long_double, Scalar::certified})
        CHECK(at(0.1, 0.1, scalar) == infinity);
    CHECK(at(0.1 + 0x1p-40, 0.1, Scalar::float_) == infinity);
    CHECK(at(0.1 + 0x1p-40, 0.1, Scalar::double_) > 0);
    // An edge from (1 + e, 1) to (−1, −(1 − e)), e = 2^-52, passes the ray at (0, 0): (1 + e)(1 − e) − 1 = −e², and
    // computed as 0.
    const double e = 0x1p-52;
    scene.view = ParallelView{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    scene.triangles = {{{Vec3<double>{1 + e, 1, 0}, {-1, -(1 - e), 0}, {3, -3, 0}}, {1, 2, 3}}};
    const Measurement* const wanted = find_measurement("margin");
    for (const Scalar scalar : {Scalar::double_, Scalar::certified}) {
        Options options;
        options.scalar = scalar;
        CHECK(measure(scene, options, {&wanted, 1})[0][0].values[0] == -infinity);
    }
}

TEST_CASE("bits-lost: none where t is a whole number, few on a sphere's slope") {
    CHECK(value(paper, "bits-lost", gx, gy) == 0);
    const double slope = value(paper, "bits-lost", gx + 10, gy + 17);
    CHECK(slope >= 0);
    CHECK(slope < 3);
    CHECK(std::isnan(value(paper, "bits-lost", nx, ny)));
}

TEST_CASE("drift: none without turns; 36 turns of 10 degrees leave some, and no more than their roundings") {
    CHECK(value(paper, "drift", 0, 0) == 0);
    Options options;
    options.turns.assign(36, {Axis::z, 10});
    const double drift = value(paper, "drift", 0, 0, options);
    CHECK(drift > 0);
    CHECK(drift < 36 * 8 * 707 * 0x1p-52);  // 36 steps, a few roundings each, of coordinates up to 707
}

namespace {

/// A triangle and a direction in small whole numbers, whose side products are whole numbers, too.
struct WholeTriangle {
    std::array<std::array<int, 3>, 4> corners{};  // A, B, C, D

    explicit WholeTriangle(std::mt19937_64& random) {
        for (auto& corner : corners)
            for (int& coordinate : corner) coordinate = static_cast<int>(random() % 17) - 8;
    }

    template <class Real>
    Vec3<Real> corner(std::size_t i, int exponent) const {
        const auto [x, y, z] = corners[i];
        const auto scaled = [&](int whole) { return std::ldexp(static_cast<Real>(whole), exponent); };
        return {scaled(x), scaled(y), scaled(z)};
    }

    /// D·(Y × X), at most 8 · 6 · 64.
    int side(std::size_t x, std::size_t y) const {
        const auto &X = corners[x], &Y = corners[y], &D = corners[3];
        return D[0] * (Y[1] * X[2] - Y[2] * X[1]) + D[1] * (Y[2] * X[0] - Y[0] * X[2]) +
               D[2] * (Y[0] * X[1] - Y[1] * X[0]);
    }
};

template <class Number>
bool are_of_one_sign(Number a, Number b, Number c) {
    const bool none_below = a >= 0 && b >= 0 && c >= 0, none_above = a <= 0 && b <= 0 && c <= 0;
    return none_below != none_above;
}

/// What is measured of it when all lengths are 2^exponent times as large.
template <class Real>
TriangleNumbers measured_at(const WholeTriangle& triangle, int exponent) {
    TriangleNumbers numbers;
    numbers.take(Triangle<Real>{triangle.corner<Real>(0, exponent), triangle.corner<Real>(1, exponent),
                                triangle.corner<Real>(2, exponent)},
                 triangle.corner<Real>(3, 0));
    return numbers;
}

/// Whether the scalar says hit where whole numbers say miss, or the other way round.
template <class Real>
bool is_wrong(const WholeTriangle& triangle, int exponent) {
    const Vec3<Real> D = triangle.corner<Real>(3, 0);
    const auto s = sides(D, Triangle<Real>{triangle.corner<Real>(0, exponent), triangle.corner<Real>(1, exponent),
                                           triangle.corner<Real>(2, exponent)});
    return are_of_one_sign(s.a, s.b, s.c) !=
           are_of_one_sign(triangle.side(1, 2), triangle.side(2, 0), triangle.side(0, 1));
}

}  // namespace

// Coordinates of at most 8 · 2^e, side products of at least 2^2e: float's least number is 2^-149, so from e = -75 on
// down products of two are rounded to multiples of it, and signs get lost. So with doubles, from 2^-537 = 2e-162 on.
TEST_CASE_TEMPLATE("margin: above 0 no sign is wrong, however small or large the numbers", Real, float, double,
                   long double) {
    std::mt19937_64 random(1208);
    constexpr int least = std::numeric_limits<Real>::min_exponent - std::numeric_limits<Real>::digits;
    constexpr int most = std::numeric_limits<Real>::max_exponent - 5;
    int wrong = 0, by_underflow = 0;
    for (int i = 0; i < 3000; ++i) {
        const WholeTriangle triangle(random);
        const double whole = measured_at<Real>(triangle, 0).margin;
        for (const int exponent : {least, least / 2 - 3, least / 2 - 2, least / 2 - 1, least / 2, least / 2 + 1, -10,
                                   10, most / 3, most / 2, most}) {
            const TriangleNumbers numbers = measured_at<Real>(triangle, exponent);
            REQUIRE_FALSE(std::isnan(numbers.margin));
            // A product that is off by less than itself is less than twice what it should be.
            REQUIRE(numbers.margin <= std::max(whole, 0.0) + std::log10(2.0));
            if (exponent == 10 || exponent == -10 || exponent == most / 3)
                REQUIRE(numbers.margin == whole);  // a power of two changes no digit
            if (!is_wrong<Real>(triangle, exponent)) continue;
            ++wrong;
            by_underflow += exponent < 0;
            REQUIRE(numbers.margin <= 0);
        }
    }
    CHECK(wrong > 1000);
    CHECK(by_underflow > 1000);
}

// a+b+c and −D·((B−A)×(C−A)) are four side products. Of whole numbers nothing is rounded but what underflows, by less
// than η(3/2 + |D|₁) in each; the unit is at least 3/8 η(2 + |D|₁) then: 4 · 8/3 of them at most, and in most cases
// less.
TEST_CASE_TEMPLATE("identity: a few units, of small numbers, too; side: from -1 to 1", Real, float, double) {
    std::mt19937_64 random(1209);
    constexpr int least = std::numeric_limits<Real>::min_exponent - std::numeric_limits<Real>::digits;
    double largest = 0;
    for (int i = 0; i < 3000; ++i) {
        const WholeTriangle triangle(random);
        for (const int exponent : {least, least / 2 - 3, least / 2 - 1, least / 2, 0, 10}) {
            const TriangleNumbers numbers = measured_at<Real>(triangle, exponent);
            REQUIRE(numbers.identity <= 32 / 3.0);
            if (exponent >= 0) REQUIRE(numbers.identity == 0);
            largest = std::max(largest, numbers.identity);
            if (exponent >= 0) REQUIRE(std::abs(numbers.side) <= 1);
        }
    }
    CHECK(largest > 0);
}

TEST_CASE("numbers too large for the scalar: the margin decides nothing, the others have no value") {
    TriangleNumbers numbers;
    numbers.take(Triangle<double>{{1e110, 0, 1}, {0, 1e110, 2}, {-1e110, -1e110, 3}}, {1e110, 1e110, -1e110});
    CHECK(numbers.tested);
    CHECK(numbers.margin == -std::numeric_limits<double>::infinity());
    CHECK(std::isnan(numbers.identity));
    CHECK(std::isnan(numbers.deficit));
    // Long double holds them: a is D·(C × B) = 1e330 · …, its terms' sizes are at most some times as much.
    if (std::numeric_limits<long double>::max_exponent < 2000) return;
    TriangleNumbers in_long_double;
    in_long_double.take(convert<long double>(Triangle<double>{{1e110, 0, 1}, {0, 1e110, 2}, {-1e110, -1e110, 3}}),
                        Vec3<long double>{1e110L, 1e110L, -1e110L});
    CHECK(in_long_double.margin > 10);
    CHECK(std::isfinite(in_long_double.identity));
    CHECK_FALSE(std::isnan(in_long_double.deficit));
}

// Rays down from z = 4·2^-76 on the triangle; the same picture 2^76 times as large has no wrong pixel.
TEST_CASE("margin and verdict of a picture in float, of coordinates k · 2^-76") {
    std::mt19937_64 random(1210);
    Options options;
    options.scalar = Scalar::float_;
    const Measurement* const wanted[] = {find_measurement("verdict"), find_measurement("margin")};
    int wrong = 0;
    for (int i = 0; i < 200; ++i) {
        const auto coordinate = [&] { return std::ldexp(static_cast<double>(random() % 9) - 4, -76); };
        const auto corner = [&] {
            const double x = coordinate(), y = coordinate();
            return Vec3<double>{x, y, 0};
        };
        Scene scene;
        scene.width = scene.height = 9;
        const double unit = 0x1p-76;
        scene.view = ParallelView{{-4 * unit, -4 * unit, 4 * unit}, {unit, 0, 0}, {0, unit, 0}, {0, 0, -1}};
        const Vec3<double> A = corner(), B = corner(), C = corner();
        scene.triangles = {{{A, B, C}, {1, 2, 3}}};
        const auto channels = measure(scene, options, wanted);
        const std::vector<double>&verdict = channels[0][0].values, &margin = channels[1][0].values;
        for (std::size_t pixel = 0; pixel < verdict.size(); ++pixel) {
            if (verdict[pixel] == 0) continue;
            ++wrong;
            REQUIRE(margin[pixel] <= 0);
        }
    }
    CHECK(wrong > 100);
}

// 1e200 squared is no double, nor is 1e-200 squared but 0.
TEST_CASE("drift: of large and of small scenes, too") {
    for (const double size : {1e200, 1e-200}) {
        Scene scene = paper;
        scene.width = scene.height = 2;
        scene.view = ParallelView{{5 * size, 3 * size, size}, {0, size, 0}, {0, 0, size}, {-1, 0, 0}};
        Options options;
        options.turns.assign(36, {Axis::z, 10});
        const Measurement* const wanted = find_measurement("drift");
        const double drift = measure(scene, options, {&wanted, 1})[0][0].values[0];
        CHECK(drift > 0);
        CHECK(drift < 36 * 8 * 7 * size * 0x1p-52);
    }
}

// A long double beyond all doubles has bits to lose, too; and a number that is its truth has lost none.
TEST_CASE("bits-lost of the largest numbers") {
    CHECK(bits_lost(std::numeric_limits<double>::max(), Exact(std::numeric_limits<double>::max())) == 0);
    CHECK(bits_lost(std::numeric_limits<double>::max(), Exact(std::nextafter(std::numeric_limits<double>::max(), 0))) ==
          1);  // one ulp
    if (std::numeric_limits<long double>::max_exponent < 2000) return;
    const Exact large = Exact(0x1p1000) * Exact(0x1p1000);
    CHECK(bits_lost(std::ldexp(1.0L, 2000), large) == 0);
    CHECK(bits_lost(std::nextafter(std::ldexp(1.0L, 2000), HUGE_VALL), large) == 1);
}

TEST_CASE("every measurement has a name, an explanation and its channels' names") {
    for (const Measurement& each : measurements()) {
        CHECK(find_measurement(each.name) == &each);
        CHECK_FALSE(each.explanation.empty());
        CHECK((each.channels().size() == 1 || each.channels().size() == 3));
    }
    CHECK(find_measurement("dept") == nullptr);
}
