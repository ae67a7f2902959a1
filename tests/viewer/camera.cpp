#include "viewer/model/space/camera.hpp"
#include "viewer/model/space/flight.hpp"

#include <doctest.h>

#include <cmath>
#include <numbers>

#include "explain/explain.hpp"
#include "render/view.hpp"
#include "viewer/model/space/space.hpp"

using namespace glassbox;

namespace {

constexpr Ball unit_ball{{0, 0, 0}, 1};
constexpr Upright z_up{{0, 0, 1}, {1, 0, 0}};
constexpr Point area{400, 200};

void check_equal(const Vec3<double>& is, const Vec3<double>& should, double within = 1e-12) {
    CAPTURE(is.x);
    CAPTURE(is.y);
    CAPTURE(is.z);
    CHECK(length(is - should) <= within);
}

void check_equal(Point is, Point should, double within = 1e-9) {
    CAPTURE(is.x);
    CAPTURE(is.y);
    CHECK(std::hypot(is.x - should.x, is.y - should.y) <= within);
}

/// How far a point is from a ray's line.
double distance(const Ray<double>& ray, const Vec3<double>& point) { return length(cross(point - ray.P, unit(ray.D))); }

/// A sphere before a pinhole, as the room has it.
Scene pinhole_scene() {
    Scene scene;
    scene.width = 60;
    scene.height = 40;
    scene.view = PinholeView{{10, 0, 2}, {0, 0, 1}, {0, 0, 1}, 40};
    scene.spheres = {{{0, 0, 1}, 2, {200, 0, 0}}};
    return scene;
}

}  // namespace

TEST_CASE("from the picture's own side its right is right, and up is up") {
    // Rays run along -x, so the viewer stands on +x: with z up, +y is on the viewer's right.
    const Camera c = camera({0, 0, 1}, unit_ball, z_up, area);
    check_equal(c.back, {1, 0, 0});
    check_equal(c.right, {0, 1, 0});
    check_equal(c.up, {0, 0, 1});
    const Point middle = project(c, {0, 0, 0}).at;
    check_equal(middle, {200, 100});
    CHECK(project(c, {0, 0.5, 0}).at.x > 200);
    CHECK(project(c, {0, 0, 0.5}).at.y < 100);  // screens count down
}

TEST_CASE("azimuth counts counter-clockwise from above, elevation upwards") {
    // A quarter turn from +x counter-clockwise about z is +y; from there +x is on the left, so right is -x.
    const Camera side = camera({90, 0, 1}, unit_ball, z_up, area);
    check_equal(side.back, {0, 1, 0});
    check_equal(side.right, {-1, 0, 0});
    // From 30° above: back = (cos 30°, 0, sin 30°), and up leans away from the viewer.
    const Camera above = camera({0, 30, 1}, unit_ball, z_up, area);
    check_equal(above.back, {std::sqrt(3) / 2, 0, 0.5});
    check_equal(above.up, {-0.5, 0, std::sqrt(3) / 2});
}

TEST_CASE("at distance 1 a ball just fits the smaller side") {
    // 30° from top to bottom: the ball's outline is where the sight ray touches it, sin 15° = r / distance. In the
    // screen's upper edge, 100 pixels above the middle, tan 15° = 100 / focal.
    const double sin_15 = (std::sqrt(6) - std::sqrt(2)) / 4, tan_15 = 2 - std::sqrt(3);
    const Camera c = camera({0, 0, 1}, unit_ball, z_up, area);
    CHECK(c.distance == doctest::Approx(1 / sin_15));
    CHECK(c.focal == doctest::Approx(100 / tan_15));
    // The ray touches the ball at (sin 15°, 0, cos 15°), seen from the eye on +x.
    const double cos_15 = std::sqrt(1 - sin_15 * sin_15);
    check_equal(project(c, {sin_15, 0, cos_15}).at, {200, 0});
    // A ball twice as far away, twice as large: the same picture.
    const Camera twice = camera({0, 0, 1}, {{5, 6, 7}, 2}, z_up, area);
    check_equal(project(twice, {5 + 2 * sin_15, 6, 7 + 2 * cos_15}).at, {200, 0});
}

TEST_CASE("what is twice as deep looks half as large") {
    const Camera c = camera({0, 0, 1}, unit_ball, z_up, area);
    const Projected at_middle = project(c, {0, 0.1, 0});
    CHECK(at_middle.depth == doctest::Approx(c.distance));
    // One distance further back the depth is 2 distances.
    const Projected deep = project(c, {-c.distance, 0.1, 0});
    CHECK(deep.depth == doctest::Approx(2 * c.distance));
    CHECK(deep.at.x - 200 == doctest::Approx((at_middle.at.x - 200) / 2));
    // A pixel there is twice as long.
    CHECK(length_of_pixel(c, {-c.distance, 0, 0}) == doctest::Approx(2 * length_of_pixel(c, {0, 0, 0})));
    CHECK(length_of_pixel(c, {0, 0, 0}) * (at_middle.at.x - 200) == doctest::Approx(0.1));
}

TEST_CASE("the ray through a point of the screen meets what is projected there") {
    const Camera c = camera({-60, 25, 1.5}, {{3, -2, 1}, 4}, z_up, area);
    const Vec3<double> point{2, 1, -0.5};
    const Projected seen = project(c, point);
    const Ray<double> ray = ray_through(c, seen.at);
    check_equal(ray.P, eye(c));
    check_equal(at(ray, seen.depth), point, 1e-9);
}

TEST_CASE("of a line that runs through the eye's plane the part in front is drawn, and only what is on the screen") {
    const Camera c = camera({0, 0, 1}, unit_ball, z_up, area);
    CHECK(in_front(c, {0, 0, 0}));
    CHECK_FALSE(in_front(c, eye(c)));
    CHECK_FALSE(in_front(c, {100, 0, 0}));
    // Along the camera's axis, from the middle to far behind the eye.
    const auto along = visible_part(c, {0, 0, 0}, {100, 0, 0});
    REQUIRE(along);
    check_equal(along->first, {0, 0, 0});
    CHECK(in_front(c, along->second));
    CHECK(along->second.x < c.distance);
    CHECK(along->second.x > 0.99 * c.distance);
    // Across the middle, and out of the screen on both sides: 400 pixels remain, from edge to edge.
    const auto across = visible_part(c, {0, -50, 0}, {0, 50, 0});
    REQUIRE(across);
    check_equal(project(c, across->first).at, {0, 100});
    check_equal(project(c, across->second).at, {400, 100});
    // Inside nothing is changed, to the bit; beside and behind nothing is left.
    const auto inside = visible_part(c, {0, .1, .2}, {0, -.1, .3});
    REQUIRE(inside);
    CHECK(inside->first == Vec3<double>{0, .1, .2});
    CHECK(inside->second == Vec3<double>{0, -.1, .3});
    CHECK_FALSE(visible_part(c, {0, -50, 40}, {0, 50, 40}));
    CHECK_FALSE(visible_part(c, {50, 0, 0}, {60, 1, 0}));
}

TEST_CASE("up is the world's axis that the picture's up is closest to") {
    // The paper's view looks along -x with z up.
    const Upright paper = upright(view(Scene{}, Options{}));
    Scene scene;
    scene.view = ParallelView{};
    const Upright parallel = upright(view(scene, Options{}));
    check_equal(parallel.up, {0, 0, 1});
    check_equal(parallel.front, {1, 0, 0});
    check_equal(paper.up, {0, 0, 1});
    // A pinhole that looks along -z from above, its up along y: y is up, the viewer on +z.
    scene.view = PinholeView{{0, 0, 9}, {0, 0, 0}, {0, 1, 0}, 45};
    const Upright pinhole = upright(view(scene, Options{}));
    check_equal(pinhole.up, {0, 1, 0});
    check_equal(pinhole.front, {0, 0, 1});
    // Upside down: the picture's up along -z.
    scene.view = ParallelView{{0, 0, 0}, {0, -1, 0}, {0, 0, -1}, {-1, 0, 0}};
    check_equal(upright(view(scene, Options{})).up, {0, 0, -1});
}

TEST_CASE("dragging right turns the scene right, dragging down shows it from above") {
    // The camera goes the other way: clockwise, by half a degree a pixel at text size 18.
    const Orbit right = dragged({0, 0, 1}, {40, 0}, 18);
    CHECK(right.azimuth == doctest::Approx(-20));
    const Vec3<double> nearest_point{1, 0, 0};  // of the ball, to the eye at azimuth 0
    CHECK(project(camera(right, unit_ball, z_up, area), nearest_point).at.x > 200);
    CHECK(dragged({0, 0, 1}, {0, 40}, 18).elevation == doctest::Approx(20));
    // Never over the pole; distances stay within limits.
    CHECK(dragged({0, 80, 1}, {0, 4000}, 18).elevation == greatest_elevation);
    CHECK(closer({0, 0, 1}, 1e-9).distance == least_distance);
    CHECK(closer({0, 0, 1}, 1e9).distance == greatest_distance);
    CHECK(closer({0, 0, 2}, 0.5).distance == 1);
}

TEST_CASE("the pinned ray passes through its pixel's place on the picture, turned or not") {
    for (const Scene& scene : {Scene{}, pinhole_scene()})
        for (const double degrees : {0.0, 30.0, -75.0}) {
            CAPTURE(degrees);
            Setup setup = setup_of(scene);
            setup.options.turns = {{Axis::z, degrees}, {Axis::x, degrees / 3}};
            const SurfacesInSpace surfaces = surfaces_in_space(scene, 5);
            const int x = scene.width / 3, y = scene.height / 5;
            const Story story = explain(scene, setup.options, x, y);
            const SpaceDrawing drawing = space_drawing(scene, setup, surfaces, &story, nullptr);
            // The middle of pixel (x, y).
            const Vec3<double> place = drawing.picture.at(x + 0.5, y + 0.5);
            CHECK(distance(story.ray, place) <= 1e-9);
            // And back: the ray meets the picture in that pixel, if it starts a little before the picture.
            const Ray<double> from_before{story.ray.P - 0.01 * story.ray.D, story.ray.D};
            const auto met = drawing.picture.met_by(from_before);
            REQUIRE(met);
            check_equal(*met, {x + 0.5, y + 0.5}, 1e-6);
            // The line drawn begins where the ray does, and lies on it.
            bool drawn = false;
            for (const LineInSpace& line : drawing.lines)
                if (line.ink == Ink::pinned) {
                    drawn = true;
                    CHECK(distance(story.ray, line.from) <= 1e-9);
                    CHECK(distance(story.ray, line.to) <= 1e-6);
                }
            CHECK(drawn);
        }
}

TEST_CASE("the picture's corners are half a pixel beyond those pixels' rays") {
    // The paper's view: the ray of column j and row i starts at (500, j, i), 0 ≤ i, j ≤ 499. Top left is column 0 of
    // row 499, and the picture's corner half a pixel out: (500, -0.5, 499.5).
    const PictureInSpace picture{view(Scene{}, Options{}), 500, 500, 0};
    check_equal(picture.at(0, 0), {500, -0.5, 499.5});
    check_equal(picture.at(500, 500), {500, 499.5, -0.5});
}

TEST_CASE("hits are numbered along the ray, and dashed lines go on behind the first") {
    // Along -x through (·, 250, 250): the near sphere, x from 250 to 150, is entered at t = 500 - 250 = 250; the far
    // one, x from 50 to -50, at t = 450. They are left at 350 and 550.
    Scene scene;
    scene.spheres = {{{0, 250, 250}, 50, {255, 0, 0}}, {{200, 250, 250}, 50, {0, 255, 0}}};
    const Setup setup = setup_of(scene);
    const Story story = explain(scene, setup.options, 250, 499 - 250);
    const SpaceDrawing drawing = space_drawing(scene, setup, surfaces_in_space(scene, 5), &story, nullptr);
    int numbered = 0;
    for (const LabelInSpace& label : drawing.labels) {
        if (label.text == "1") check_equal(label.at, {250, 250, 250}), ++numbered;
        if (label.text == "2") check_equal(label.at, {50, 250, 250}), ++numbered;
    }
    CHECK(numbered == 2);
    std::vector<LineInSpace> ray;
    for (const LineInSpace& line : drawing.lines)
        if (line.ink == Ink::pinned) ray.push_back(line);
    REQUIRE(ray.size() == 2);
    CHECK_FALSE(ray[0].dashed);
    check_equal(ray[0].from, {500, 250, 250});
    check_equal(ray[0].to, {250, 250, 250});
    CHECK(ray[1].dashed);
    CHECK(length(ray[1].to - drawing.sight.center) > 2 * drawing.sight.radius);
    // At the hit: the normal of the near sphere looks back along the ray, the light is unit(1000, 250, 250).
    // The viewer is where the ray comes from.
    bool normal_seen = false, light_seen = false, viewer_seen = false;
    for (const ArrowInSpace& arrow : drawing.arrows) {
        check_equal(arrow.from, {250, 250, 250});
        if (std::string_view(arrow.name) == "n") check_equal(arrow.direction, {1, 0, 0}), normal_seen = true;
        if (std::string_view(arrow.name) == "r") check_equal(arrow.direction, {1, 0, 0}), viewer_seen = true;
        if (std::string_view(arrow.name) == "l")
            check_equal(arrow.direction, unit(Vec3<double>{1000, 250, 250})), light_seen = true;
    }
    CHECK(normal_seen);
    CHECK(light_seen);
    CHECK(viewer_seen);
}

TEST_CASE("what is under the mouse is the surface or the picture that is nearest there") {
    Scene scene;
    scene.spheres = {{{0, 250, 250}, 50, {255, 0, 0}}, {{200, 250, 250}, 50, {0, 255, 0}}};
    const SurfacesInSpace surfaces = surfaces_in_space(scene, 5);
    const SpaceDrawing drawing = space_drawing(scene, setup_of(scene), surfaces, nullptr, nullptr);
    // From behind, on -x: the sphere about x = 0 comes first. From the front the picture, x = 500, is before both.
    const Camera behind = camera({180, 0, 1}, drawing.sight, surfaces.upright, area);
    const SeenInSpace first = seen_at(behind, project(behind, {0, 250, 250}).at, surfaces, drawing);
    CHECK(first.surface == std::optional<std::size_t>(0));
    CHECK_FALSE(first.on_picture);
    const Camera front = camera({0, 0, 1}, drawing.sight, surfaces.upright, area);
    const SeenInSpace picture = seen_at(front, project(front, {500, 100, 400}).at, surfaces, drawing);
    REQUIRE(picture.on_picture);
    CHECK_FALSE(picture.surface);
    // Column 100's middle, row 400's: 500 - 0.5 - 400 from the top.
    check_equal(*picture.on_picture, {100.5, 99.5}, 1e-6);
    CHECK_FALSE(seen_at(front, {0, 0}, surfaces, drawing).surface);
}

TEST_CASE("at distance 1 the outline fills 0.86 of the pane, in its middle; at the focus all turns about that") {
    const std::vector<Vec3<double>> outline{{0, -.5, 0}, {0, .5, 0}, {0, 0, -.1}, {0, 0, .2}};
    const InPane shown{unit_ball, {0, .5, 0}, outline, z_up, {900, 300}};
    const Camera all = camera_of({0, 0, 1}, shown);
    Point least{1e9, 1e9}, greatest{-1e9, -1e9};
    for (const Vec3<double>& point : outline) {
        const Point at = project(all, point).at;
        least = {std::min(least.x, at.x), std::min(least.y, at.y)};
        greatest = {std::max(greatest.x, at.x), std::max(greatest.y, at.y)};
    }
    // 1 wide and 0.3 high in a pane of 3 : 1: as wide as 0.86 of it, 774; in the middle, 450 and 150.
    CHECK(std::max((greatest.x - least.x) / 900, (greatest.y - least.y) / 300) == doctest::Approx(.86));
    CHECK((least.x + greatest.x) / 2 == doctest::Approx(450));
    CHECK((least.y + greatest.y) / 2 == doctest::Approx(150));
    const Camera near = camera_of({0, 0, .1}, shown);
    check_equal(project(near, {0, .5, 0}).at, {450, 150}, 1e-6);
    // Shifted by a pane's width to the right.
    const Orbit shifted = panned({0, 0, .1}, {900, 0}, {900, 300});
    CHECK(shifted.pan == Point{1, 0});
    check_equal(project(camera_of(shifted, shown), {0, .5, 0}).at, {1350, 150}, 1e-6);
}

TEST_CASE("a flight to the hit takes half a second, a flight back, too") {
    ViewerState state;
    state.scene = std::make_shared<const Scene>();
    fly_to_hit_or_back(state);
    CHECK(flies_back(state));
    fly_on(state, .04, .25);  // half of the time: half of the way by factors, sqrt(1 · 0.04)
    CHECK(state.orbit.distance == doctest::Approx(.2));
    fly_on(state, .04, .3);
    CHECK(state.orbit.distance == .04);
    CHECK_FALSE(state.flight);
    state.orbit.pan = {.5, 0};
    fly_to_hit_or_back(state);
    fly_on(state, .04, 1);
    CHECK(state.orbit == Orbit{});
}

TEST_CASE("stages know no surfaces, then spheres, then triangles; of many faces a sample is drawn") {
    Scene scene;
    scene.spheres = {{{0, 250, 250}, 50, {255, 0, 0}}};
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {0, 10, 0}, {0, 0, 10}, {5, 5, 5}};
    for (int i = 0; i < 1000; ++i) mesh.faces.push_back({0, 1, 2});
    scene.meshes = {mesh};
    CHECK(surfaces_in_space(scene, 1).numbers.empty());
    CHECK(surfaces_in_space(scene, 2).numbers.size() == 1);
    CHECK(surfaces_in_space(scene, 3).numbers.size() == 1001);
    // At most 100 of 1000: every tenth or so. The box holds all of the mesh.
    const SurfacesInSpace few = surfaces_in_space(scene, 3, 100, 100);
    CHECK(few.shown.triangles.size() <= 101);
    CHECK(few.shown.triangles.size() > 50);
    CHECK(few.all_triangles == 1000);
    REQUIRE(few.boxes.size() == 1);
    check_equal(few.boxes[0][1], {5, 10, 10});
}

TEST_CASE("a mesh of very many triangles is drawn coarser, and still covers its shape") {
    // A square sheet of 200 × 200 × 2 = 80,000 triangles with sides of 1, from 0 to 200 in y and z: its coarser one
    // must cover nearly its area, 40,000, with corners on it.
    Scene scene;
    Mesh sheet;
    constexpr std::uint32_t n = 200;
    for (std::uint32_t i = 0; i <= n; ++i)
        for (std::uint32_t j = 0; j <= n; ++j) sheet.vertices.push_back({5, 1.0 * i, 1.0 * j});
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < n; ++j) {
            const std::uint32_t k = i * (n + 1) + j;
            sheet.faces.push_back({k, k + n + 1, k + 1});
            sheet.faces.push_back({k + 1, k + n + 1, k + n + 2});
        }
    scene.meshes = {sheet};
    const SurfacesInSpace surfaces = surfaces_in_space(scene, 5);
    CHECK(surfaces.coarser);
    CHECK(surfaces.all_triangles == 80000);
    CHECK(surfaces.shown.triangles.size() <= 3000);
    CHECK(surfaces.shown.triangles.size() > 1000);
    double covered = 0;
    for (const auto& [A, B, C] : surfaces.shown.triangles) {
        CHECK(A.x == 5);
        covered += length(cross(B - A, C - A)) / 2;
    }
    CHECK(covered > 0.9 * 40000);
    CHECK(covered < 1.01 * 40000);
    // N right-angled triangles with legs l cover N l²/2, and the mean of their sides is l (2 + √2)/3.
    const double leg = std::sqrt(2 * 40000.0 / static_cast<double>(surfaces.shown.triangles.size()));
    CHECK(surfaces.side == doctest::Approx(leg * (2 + std::sqrt(2.0)) / 3).epsilon(0.1));
    // From 10 away such a side covers side · focal/10 pixels: its edges are drawn from 12 on.
    Camera from_10;
    from_10.distance = 10;
    from_10.focal = 121 / surfaces.side;
    CHECK(edges_are_seen(surfaces, from_10));
    from_10.focal = 119 / surfaces.side;
    CHECK_FALSE(edges_are_seen(surfaces, from_10));
    CHECK(edges_are_seen(SurfacesInSpace(), from_10));  // edges of the scene's own triangles
    // Which surface is seen there is not told: many stand behind one.
    const SpaceDrawing drawing = space_drawing(scene, setup_of(scene), surfaces, nullptr, nullptr);
    const Camera behind = camera({180, 0, 1}, drawing.sight, surfaces.upright, area);
    CHECK_FALSE(seen_at(behind, project(behind, {5, 100, 100}).at, surfaces, drawing).surface);
}

TEST_CASE("large triangles are cut into parts that cover them exactly") {
    // The area of all parts is the triangle's own, 400·300/2; and the outer sides are marked as its edges: their
    // lengths add up to 400 + 300 + 500.
    Scene scene;
    scene.triangles = {{{{{0, 0, 0}, {0, 400, 0}, {0, 0, 300}}}, {1, 2, 3}}};
    const SurfacesInSpace surfaces = surfaces_in_space(scene, 5);
    CHECK(surfaces.parts.size() > 4);
    double covered = 0, rim = 0;
    for (const SurfacesInSpace::Part& part : surfaces.parts) {
        const auto& [A, B, C] = part.corners;
        covered += length(cross(B - A, C - A)) / 2;
        for (std::size_t i = 0; i < 3; ++i)
            if (part.on_its_edge[i]) rim += length(part.corners[(i + 1) % 3] - part.corners[i]);
    }
    CHECK(covered == doctest::Approx(60000));
    CHECK(rim == doctest::Approx(1200));
}

// A strip of n unit squares, each of two triangles: n + 1 sides across, n diagonals, 2n along.
TEST_CASE("of many triangles an edge that two share is drawn once, of few with each") {
    const auto edges = [](int squares) {
        Scene scene;
        for (int i = 0; i < squares; ++i) {
            const double y = i;
            scene.triangles.push_back({{{{0, y, 0}, {0, y + 1, 0}, {0, y, 1}}}, {1, 2, 3}});
            scene.triangles.push_back({{{{0, y + 1, 1}, {0, y, 1}, {0, y + 1, 0}}}, {1, 2, 3}});
        }
        double sum = 0;
        for (const SurfacesInSpace::Part& part : surfaces_in_space(scene, 5).parts)
            for (std::size_t i = 0; i < 3; ++i)
                if (part.on_its_edge[i]) sum += length(part.corners[(i + 1) % 3] - part.corners[i]);
        return sum;
    };
    const double diagonal = std::sqrt(2.0);
    CHECK(edges(10) == doctest::Approx(10 * 2 * (2 + diagonal)));
    CHECK(edges(150) == doctest::Approx(151 + 150 * diagonal + 2 * 150));
}
