// Scenes in which a search, a judge or a normal was once wrong, with answers worked out by hand.
#include <doctest.h>

#include <cmath>

#include "render/measure/measurements.hpp"
#include "render/render.hpp"
#include "render/search/surface_normal.hpp"

using namespace glassbox;

namespace {

constexpr Rgb green{0, 255, 0}, red{255, 0, 0}, blue{0, 0, 255};

/// The measurement's value at a pixel.
double measured(const Scene& scene, const Options& options, const char* what, int x = 0, int y = 0) {
    const Measurement* const wanted[] = {find_measurement(what)};
    const std::vector<std::vector<Channel>> channels = measure(scene, options, wanted, {});
    return channels[0][0].at({x, y});
}

}  // namespace

TEST_CASE("what lies before a triangle whose weights are hardly above their bounds is seen") {
    // Seen along the ray, -x, the red triangle's corners lie at (-1/16, -1/16), (1/8, -1/16) and (-1/16, 1/8): three
    // equal weights, so the ray meets it at x = (99 + 90 + 90) / 3 = 93, t = 7. The sphere begins at x = 95 + 1, t = 4.
    // The large triangle far behind makes the bound of all weights as large as the red triangle's are.
    const double y = 1048576, z = 1398101.2968749956;
    Scene scene;
    scene.width = scene.height = 1;
    scene.border = {};
    scene.view = ParallelView{{100, y, z}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}};
    scene.spheres = {{{95, y, z}, 1, green}};
    scene.triangles = {{{Vec3<double>{99, 1048575.9375, 1398101.2343749956},
                         {90, 1048576.125, 1398101.2343749956},
                         {90, 1048575.9375, 1398101.4218749956}},
                        red},
                       {{Vec3<double>{-1e7, -8951424, -8601898.703125004},
                         {-1e7, 11048576, -8601898.703125004},
                         {-1e7, 1048576, 11398101.296874996}},
                        blue}};
    for (const EngineChoice engine : {EngineChoice::plain, EngineChoice::fast}) {
        Options options;
        options.engine = engine;
        options.stage = 3;
        CHECK(render(scene, options).at(0, 0) == green);
        CHECK(measured(scene, options, "depth") == 4);
        CHECK(measured(scene, options, "verdict") == 0);
    }
    // What a plain scalar finds is compared with the same truth.
    Options plain;
    plain.scalar = Scalar::double_;
    CHECK(measured(scene, plain, "verdict") == 0);
}

TEST_CASE("a sphere whose squares underflow is seen where it is") {
    // As seen from the eye it is as wide as 30 degrees to each side, as r/|c| = 1/2 = sin 30°: where the pixel's
    // distance from the middle is at most tan 30° = 1/√3 of that from the eye. Pixels are 2/97 wide: j² + i² ≤ 97²/12 =
    // 784.08. The triangle fills the rest: it is at least 2 wide on both sides up to z = 1.
    Scene scene;
    scene.width = scene.height = 97;
    scene.border = {};
    PinholeView eye{{0, 0, 0}, {-1, 0, 0}};
    eye.field_of_view = 90;
    scene.view = eye;
    scene.triangles = {{{Vec3<double>{-1, -5, -5}, {-1, 5, -5}, {-1, 0, 5}}, red}};
    for (const double size : {3e-161, 3e-154, 3e-163, 0x1p-540, 0x1p-1060}) {
        CAPTURE(size);
        scene.spheres = {{{-size, 0, 0}, size / 2, green}};
        for (const EngineChoice engine : {EngineChoice::plain, EngineChoice::fast}) {
            Options options;
            options.engine = engine;
            options.stage = 3;
            const Image image = render(scene, options);
            int wrong = 0;
            for (int y = 0; y < 97; ++y)
                for (int x = 0; x < 97; ++x) {
                    const int j = x - 48, i = 48 - y;
                    wrong += image.at(x, y) != (j * j + i * i <= 784 ? green : red);
                }
            CHECK(wrong == 0);
        }
    }
}

TEST_CASE("a pinhole's picture does not depend on the scene's scale") {
    // Powers of two change no digit of a coordinate, nor of what is computed from it: the picture is the same to the
    // byte.
    const auto picture = [](int power) {
        const auto at = [&](double x, double y, double z) {
            return Vec3<double>{std::ldexp(x, power), std::ldexp(y, power), std::ldexp(z, power)};
        };
        Scene scene;
        scene.width = 60;
        scene.height = 45;
        scene.view = PinholeView{at(8, 1, 3), at(0, 0.3, 0.2)};
        scene.spheres = {{at(0, 0, 1), std::ldexp(1, power), green}, {at(1, 2, 0.5), std::ldexp(0.5, power), red}};
        scene.triangles = {{{at(-5, -5, 0), at(5, -5, 0), at(0, 6, 0)}, blue},
                           {{at(-4, -3, -1), at(-4, 3, -1), at(-4, 0, 4)}, red}};
        return render(scene, Options{});
    };
    const Image once = picture(0);
    for (const int power : {40, 50, 55, 200, 300, -40, -300}) {
        CAPTURE(power);
        CHECK(picture(power).pixels == once.pixels);
    }
}

TEST_CASE_TEMPLATE("a normal is the same at every size", Real, float, double, long double) {
    // (B − A) × (C − A) = (1, 2, 0) × (−1, 3, 2) = (4, −2, 5), of length √45; times powers of two, each edge by its
    // own.
    const auto length = std::sqrt(Real(45));
    const Vec3<Real> truth{4 / length, -2 / length, 5 / length};
    const auto close = [](const Vec3<Real>& n, const Vec3<Real>& expected) {
        const Vec3<Real> d = n - expected;
        const Real most = 4 * std::numeric_limits<Real>::epsilon();
        return std::abs(d.x) <= most && std::abs(d.y) <= most && std::abs(d.z) <= most;
    };
    const int largest = std::is_same_v<Real, float> ? 124 : 1018, least = std::is_same_v<Real, float> ? -145 : -1070;
    for (const int one : {0, 50, -50, largest, least, largest / 2, least / 2})
        for (const int other : {0, 50, -50, largest, least, largest / 2, least / 2}) {
            CAPTURE(one);
            CAPTURE(other);
            const Vec3<Real> B = scaled(Vec3<Real>{1, 2, 0}, one), C = scaled(Vec3<Real>{-1, 3, 2}, other);
            CHECK(close(unit_normal(Triangle<Real>{{}, B, C}), truth));
        }
    // Corners whose differences overflow: (h, −h, −h) − (−h, −h, −h) and so on, h the largest power of two.
    const Real h = std::ldexp(Real(1), std::numeric_limits<Real>::max_exponent - 1);
    if (std::numeric_limits<Real>::max_exponent <= 1024)
        CHECK(close(unit_normal(Triangle<Real>{{-h, -h, -h}, {h, -h, -h}, {-h, h, -h}}), {0, 0, 1}));
    // A sphere's: from the centre (c, 0, 0) the ray along −x meets it at (c + r, 0, 0); and from inside, starting at c.
    for (const int size : {0, largest - 4, least + 4, largest / 2, least / 2}) {
        CAPTURE(size);
        const Real r = std::ldexp(Real(1), size);
        const Sphere<Real> sphere{{}, r};
        CHECK(close(normal_at(Ray<Real>{{4 * r, 0, 0}, {-1, 0, 0}}, 3 * r, sphere), {1, 0, 0}));
    }
    const Sphere<Real> far_off{{262144, -1048576, -1048576}, std::ldexp(Real(1), least / 2)};
    CHECK(close(normal_at(Ray<Real>{far_off.C, {0, 0, -1}}, far_off.r, far_off), {0, 0, -1}));
}

TEST_CASE_TEMPLATE("from the centre of a sphere about the origin the normal is along the ray", Real, float, double,
                   long double) {
    // Of radius 5, met from inside at t = 1, in (3, 4, 0): n = (3, 4, 0)/5. The start's exponent is that of 0.
    const Vec3<Real> n = normal_at(Ray<Real>{{0, 0, 0}, {3, 4, 0}}, Real(1), Sphere<Real>{{0, 0, 0}, 5});
    CHECK(n.x == Real(3) / 5);
    CHECK(n.y == Real(4) / 5);
    CHECK(n.z == 0);
}

TEST_CASE("a normal has its digits where t overflows or is subnormal, and far off where doubles tell nothing of it") {
    // About the origin, radius 2. From (1, 0, 10) along −z the sphere is met at z = √3, from inside, at (1, 0, 0), at
    // z = −√3. Times powers of two that make t more than any double, or leave it 24 bits.
    const auto normal = [](const Vec3<double>& P, const Vec3<double>& D, const Vec3<double>& c, double r) {
        Scene scene;
        scene.width = scene.height = 1;
        scene.view = ParallelView{P, {r, 0, 0}, {0, r, 0}, D};
        scene.spheres = {{c, r, green}};
        const Measurement* const wanted[] = {find_measurement("normal")};
        const auto n = measure(scene, {}, wanted, {}).front();
        return Vec3<double>{n[0].values[0], n[1].values[0], n[2].values[0]};
    };
    const auto expect = [](const Vec3<double>& n, const Vec3<double>& truth) {
        CHECK(std::abs(n.x - truth.x) <= 1e-15);
        CHECK(std::abs(n.y - truth.y) <= 1e-15);
        CHECK(std::abs(n.z - truth.z) <= 1e-15);
    };
    const double root3 = std::sqrt(3.0);
    struct Exponents {
        int size, of_D;
    };
    for (const Exponents& e : {Exponents{600, -500}, {1000, -1000}, {-1050, 0}, {-1050, -300}, {-1050, 300}}) {
        CAPTURE(e.size);
        CAPTURE(e.of_D);
        const auto length = [&](double x) { return std::ldexp(x, e.size); };
        const Vec3<double> D{0, 0, -std::ldexp(1.0, e.of_D)};
        expect(normal({length(1), 0, length(10)}, D, {}, length(2)), {0.5, 0, root3 / 2});
        expect(normal({length(1), 0, 0}, D, {}, length(2)), {0.5, 0, -root3 / 2});
    }
    // 2⁶⁰ radii away, the ray's line passes the centre at half a radius: l = (1/2, 0, 0), and the sphere is met at
    // z = √(1 − 1/4) before it.
    expect(normal({0.5, 0, 0x1p60}, {0, 0, -3}, {}, 1), {0.5, 0, root3 / 2});
}

TEST_CASE("a sliver has its normal, whose edges doubles take for parallel") {
    // (B − A) × (C − A) = (2 + ε, −2, 0) × (2, −2, 0) = (0, 0, −2ε): along −z, though 2 + ε is 2 in doubles.
    Scene scene;
    scene.width = scene.height = 1;
    scene.view = ParallelView{{0x1p-200, -2 + 0x1p-210, -4}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    scene.triangles = {{{Vec3<double>{-2, 0, 0}, {0x1p-190, -2, 0}, {0, -2, 0}}, green}};
    const Measurement* const wanted[] = {find_measurement("normal"), find_measurement("hits")};
    // Just above the edge from (0, −2) to (ε, −2); the edge from (−2, 0) to (ε, −2) is there at y + 2 = (ε − x)(1 − …).
    const auto measured_here = measure(scene, {}, wanted, {});
    REQUIRE(measured_here[1][0].values[0] == 1);
    CHECK(measured_here[0][0].values[0] == 0);
    CHECK(measured_here[0][1].values[0] == 0);
    CHECK(measured_here[0][2].values[0] == -1);
}

TEST_CASE("a ray that starts on a sphere, and meets another one first, is judged rightly") {
    // D = (2, 1, −2), D² = 9. From the second centre P is (−6, 0, 8), at distance 10, its radius: t₀ = 0 does not
    // count, and t₁ = 2·28/9. From the first it is (−4, −4, 6): Δ = 24² − 9(68 − 16) = 108, t₀ = (24 − √108)/9, which
    // is less.
    Scene scene;
    scene.width = scene.height = 1;
    scene.view = ParallelView{{-20, -4, -2}, {1, 0, 0}, {0, 1, 0}, {2, 1, -2}};
    scene.spheres = {{{-16, 0, -8}, 4, green}, {{-14, -4, -10}, 10, red}};
    for (const Scalar scalar : {Scalar::certified, Scalar::double_, Scalar::long_double}) {
        Options options;
        options.stage = 3;
        options.scalar = scalar;
        CHECK(render(scene, options).at(0, 0) == green);
        CHECK(measured(scene, options, "verdict") == 0);
        CHECK(measured(scene, options, "bits-lost") <= 3);
    }
    CHECK(measured(scene, {}, "hits") == 2);
}
