#include <cmath>
#include <functional>

#include "bench/cliffs/cliff.hpp"
#include "bench/cliffs/shapes.hpp"

namespace glassbox {

namespace {

using namespace shape;

/// An oblique direction, of length 1 nearly.
constexpr Vec3<double> oblique{0.6, 0.48, -0.64};

/// A ball of radius 1, and an eye near it, both `off` from the origin.
Traced one_ball(double off, int side) {
    const Vec3<double> centre = off * oblique;
    return {with(seen_from(centre + Vec3<double>{0, 0, 3}, centre, side), ColoredSphere{centre, 1, grey})};
}

/// A ball of radius 1 so far from the eye, seen as large as one at 3: through a long lens.
Traced far_ball(double off, int side) {
    Scene scene = with(seen_from({0, 0, 0}, oblique, side), ColoredSphere{off * oblique, 1, grey});
    std::get<PinholeView>(scene.view).field_of_view *= 3 / off;
    return {scene};
}

/// The same, its rays as a list.
Traced as_list(Traced traced) {
    traced.rays = picture_rays(traced.scene);
    return traced;
}

Traced small_knot(int side) { return {knot(128, side)}; }

/// A knot, and under it one triangle of that size.
Traced on_floor(double size, int side) {
    return {
        with(knot(128, side), ColoredTriangle{{{{-size, -1.5, -size}, {size, -1.5, -size}, {0, -1.5, size}}}, grey})};
}

/// A knot, and behind it one triangle of that size.
Traced before_wall(double size, int side) {
    return {with(knot(128, side), ColoredTriangle{{{{-size, -size, -10}, {size, -size, -10}, {0, size, -10}}}, grey})};
}

/// A knot, and one sphere; the eye is at (0, 0, 4).
auto and_ball(const Vec3<double>& C, double r) {
    return [=](int side) { return Traced{with(knot(128, side), {C, r, grey})}; };
}

/// Two knots of 1,536 triangles.
Traced two_knots(double apart, int side) { return {with(knot(64, side), moved(trefoil(64, 12), 1, {apart, 0, 0}))}; }

Cliff scaled(int exponent) {
    const double scale = std::ldexp(1.0, exponent);
    return {"a whole scene at scale 2^" + std::to_string(exponent), 1.2, "a knot of 3,072 triangles",
            [scale](int side) { return Traced{knot(128, side, scale)}; }, small_knot};
}

/// Hills of 3,042 triangles seen by parallel rays; the direction stays as long as it is.
Traced from_above(double scale, int side) {
    Scene scene = with(seen_from_above(2 * scale, side), moved(terrain(39), scale, {scale, scale, 0}));
    std::get<ParallelView>(scene.view).corner.z = 4 * scale;
    return {scene};
}

/// Spheres of radii from 2⁻²⁰ to 1/8, and a triangle under them.
Traced on_a_floor(double size, int side) {
    Random random(11);
    Scene scene = with(seen_from({0, 0, 4}, {0, 0, 0}, side),
                       ColoredTriangle{{{{-size, -1.5, -size}, {size, -1.5, -size}, {0, -1.5, size}}}, grey});
    for (int i = 0; i < 1000; ++i) {
        const Vec3<double> centre = random_point(random, -1, 1);
        scene.spheres.push_back({centre, std::exp2(random.between(-20, -3)), grey});
    }
    return {scene};
}

/// A ball of 81,920 triangles.
Traced large_scene(double scale, int side) {
    return {with(seen_from({0, 0, 3 * scale}, {0, 0, 0}, side), moved(icosphere(6), scale, {}))};
}

Cliff ball_at(double off, const char* text) {
    return {std::string("one sphere of radius 1, and the eye, at ") + text, 3, "both near 0",
            [off](int side) { return one_ball(off, side); }, [](int side) { return one_ball(0, side); }};
}

Cliff ball_far_off(double off, const char* text) {
    return {std::string("one sphere of radius 1 at ") + text + " from the eye", 3, "one at 3",
            [off](int side) { return far_ball(off, side); }, [](int side) { return far_ball(3, side); }};
}

/// An ordinary scene's rays, traced one by one, beside its picture.
Cliff shot_beside_picture(const char* name, std::function<Traced(int)> make) {
    return {std::string("shoot: ") + name, 10, "its picture", [make](int side) { return as_list(make(side)); }, make};
}

/// The case's rays, and those of its ordinary scene, traced one by one.
Cliff shot(Cliff cliff) {
    return {"shoot: " + cliff.name, cliff.goal, cliff.ordinary,
            [make = cliff.make](int side) { return as_list(make(side)); },
            [make = cliff.make_ordinary](int side) { return as_list(make(side)); }};
}

Cliff floor_of(double size, const char* text) {
    return {std::string("one floor triangle of ") + text, 2, "one of 10, under the same knot",
            [size](int side) { return on_floor(size, side); }, [](int side) { return on_floor(10, side); }};
}

Cliff knot_at(double off, const char* text) {
    return {std::string("a mesh at offset ") + text, 3, "the knot at 0",
            [off](int side) {
                return Traced{knot(128, side, 1, {off, off, off})};
            },
            small_knot};
}

}  // namespace

std::vector<Cliff> cliffs_of_scale() {
    return {
        shot_beside_picture("an ordinary sphere", [](int side) { return one_ball(0, side); }),
        shot_beside_picture("an ordinary mesh", small_knot),
        ball_far_off(1e6, "1e6"),
        ball_far_off(1e8, "1e8"),
        ball_far_off(1e10, "1e10"),
        ball_at(1e6, "1e6"),
        ball_at(1e8, "1e8"),
        ball_at(1e10, "1e10"),
        shot(ball_far_off(1e6, "1e6")),
        shot(ball_far_off(1e8, "1e8")),
        shot(ball_far_off(1e10, "1e10")),
        floor_of(1e5, "1e5"),
        floor_of(1e6, "1e6"),
        scaled(-50),
        scaled(-100),
        scaled(-400),
        scaled(-20),
        scaled(20),
        scaled(50),
        scaled(400),
        {"a scene of 81,920 triangles at scale 2^-60", 1.2, "the same at scale 1",
         [](int side) { return large_scene(0x1p-60, side); }, [](int side) { return large_scene(1, side); }},
        {"parallel rays from above, all at scale 2^20", 1.2, "the same at scale 1",
         [](int side) { return from_above(0x1p20, side); }, [](int side) { return from_above(1, side); }},
        {"1,000 spheres of all sizes on a floor of 1e4", 3, "on a floor of 10",
         [](int side) { return on_a_floor(1e4, side); }, [](int side) { return on_a_floor(10, side); }},
        {"the eye inside a big sphere", 2, "a ball behind the knot", and_ball({0, 0, 0}, 100), and_ball({0, 0, -3}, 1)},
        {"the eye inside a big sphere, shading apart", 2, "a sphere behind the knot that fills the picture, too",
         and_ball({0, 0, 0}, 100), and_ball({0, 0, -260}, 250)},
        {"a surface of 2^51", 2, "one of 16, behind the same knot", [](int side) { return before_wall(0x1p51, side); },
         [](int side) { return before_wall(16, side); }},
        knot_at(1e8, "1e8"),
        knot_at(1e10, "1e10"),
        shot(knot_at(1e8, "1e8")),
        shot(knot_at(1e10, "1e10")),
        {"two small meshes 1e8 apart", 3, "two knots 2 apart", [](int side) { return two_knots(1e8, side); },
         [](int side) { return two_knots(2, side); }},
        {"a mesh before a far-off sphere", 3, "a ball behind the knot", and_ball({0, 0, -1e8}, 1),
         and_ball({0, 0, -3}, 1)},
    };
}

}  // namespace glassbox
