// What `measure` writes, at pixels whose numbers can be worked out by hand.
#include "render/measurements.hpp"

#include <doctest.h>

#include <cmath>

#include "render/render.hpp"
#include "scene/scene_file.hpp"
#include "support/ulps.hpp"

using namespace glassbox;

namespace {

/// All components of one measurement at pixel (x, y).
std::vector<double> measured(const Scene& scene, const char* name, int x, int y, const Options& options = {}) {
    const Measurement* const wanted = find_measurement(name);
    REQUIRE(wanted != nullptr);
    const auto planes = measure(scene, options, {&wanted, 1});
    std::vector<double> values;
    for (const Plane& plane : planes[0])
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
    CHECK_ULPS(value(paper, "n.v", gx, gy), 1.0, 0);
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

TEST_CASE("every measurement has a name, an explanation and its planes' names") {
    for (const Measurement& each : measurements()) {
        CHECK(find_measurement(each.name) == &each);
        CHECK_FALSE(each.explanation.empty());
        CHECK((each.planes.size() == 1 || each.planes.size() == 3));
    }
    CHECK(find_measurement("dept") == nullptr);
}
