// Stage 5: turning the viewing plane about the axes of the world.
#include <algorithm>
#include <turn.hpp>
#include <vector>

#include "checks.hpp"

using namespace glassbox;
using namespace glassbox::test;

namespace {

// cos and sin of 10 degrees, from a table, to 30 digits
template <class Real>
constexpr Real cos10 = static_cast<Real>(0.984807753012208059366743024589L);
template <class Real>
constexpr Real sin10 = static_cast<Real>(0.173648177666930348851716626769L);

template <class Real>
const Vec3<Real> x{1, 0, 0};
template <class Real>
const Vec3<Real> y{0, 1, 0};
template <class Real>
const Vec3<Real> z{0, 0, 1};

/// The paper's view, and the same plane seen from an eye behind it.
template <class Real>
const Parallel<Real> paper{{{500, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {-1, 0, 0}};
template <class Real>
const Pinhole<Real> pinhole{{{500, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {1000, 250, 250}};

template <class Real>
Rotation<Real> turn(Axis axis, int degrees) {
    return rotation(Turn<Real>{axis, static_cast<Real>(degrees)});
}

template <class Real>
Rotation<Real> turns(const std::vector<Turn<Real>>& list) {
    return rotation<Real>(list);
}

/// A quarter turn about z: x goes to y, and y to -x.
template <class Real>
const Rotation<Real> quarter{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};

/// The difference of two rotations: the largest of the nine numbers' differences.
template <class Real>
Real apart(const Rotation<Real>& R, const Rotation<Real>& S) {
    const auto most = [](const Vec3<Real>& a) { return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)}); };
    return std::max({most(R.x - S.x), most(R.y - S.y), most(R.z - S.z)});
}

/// Some turns about all axes, by no round angles.
template <class Real>
std::vector<Turn<Real>> some_turns(Dice& dice, int count) {
    std::vector<Turn<Real>> list;
    for (int n = 0; n < count; ++n) {
        const Axis axis = std::array{Axis::x, Axis::y, Axis::z}[static_cast<std::size_t>(dice.whole(0, 2))];
        list.push_back({axis, dice.between(Real(-400), Real(400))});
    }
    return list;
}

}  // namespace

TEST_CASE_TEMPLATE("a rotation takes a vector's x, y and z along its columns", Real, EVERY_SCALAR) {
    // No rotation, but easy to follow: 1 (1, 2, 3) + 10 (4, 5, 6) + 100 (7, 8, 9)
    const Rotation<Real> R{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    CHECK_EXACT(R * (Vec3<Real>{1, 10, 100}), (Vec3<Real>{741, 852, 963}));
    CHECK_EXACT(R * y<Real>, (Vec3<Real>{4, 5, 6}));
    CHECK_EXACT(Rotation<Real>{} * (Vec3<Real>{1, 10, 100}), (Vec3<Real>{1, 10, 100}));
}

TEST_CASE_TEMPLATE("R * S is first S, then R", Real, EVERY_SCALAR) {
    // S takes x to y (a quarter turn about z), R takes y to z (one about x): together x goes to z, and y, which S takes
    // to -x, to -x; z, which S leaves, to -y.
    const Rotation<Real> S{y<Real>, -x<Real>, z<Real>}, R{x<Real>, z<Real>, -y<Real>};
    const Rotation<Real> both = R * S;
    CHECK_EXACT(both.x, z<Real>);
    CHECK_EXACT(both.y, -x<Real>);
    CHECK_EXACT(both.z, -y<Real>);
}

TEST_CASE_TEMPLATE("key d: 10 degrees about z take x towards y, and y away from x", Real, EVERY_SCALAR) {
    // counter-clockwise as seen from z's tip, where x points right and y up
    const Rotation<Real> d = turn<Real>(Axis::z, 10);
    CHECK_ULPS(d.x, (Vec3<Real>{cos10<Real>, sin10<Real>, 0}), 1);
    CHECK_ULPS(d.y, (Vec3<Real>{-sin10<Real>, cos10<Real>, 0}), 1);
    CHECK_EXACT(d.z, z<Real>);
}

TEST_CASE_TEMPLATE("key w: 10 degrees about y take z towards x, and x away from z", Real, EVERY_SCALAR) {
    // counter-clockwise as seen from y's tip, where z points right and x up: x, y, z take turns
    const Rotation<Real> w = turn<Real>(Axis::y, 10);
    CHECK_ULPS(w.z, (Vec3<Real>{sin10<Real>, 0, cos10<Real>}), 1);
    CHECK_ULPS(w.x, (Vec3<Real>{cos10<Real>, 0, -sin10<Real>}), 1);
    CHECK_EXACT(w.y, y<Real>);
}

TEST_CASE_TEMPLATE("10 degrees about x take y towards z", Real, EVERY_SCALAR) {
    const Rotation<Real> R = turn<Real>(Axis::x, 10);
    CHECK_ULPS(R.y, (Vec3<Real>{0, cos10<Real>, sin10<Real>}), 1);
    CHECK_ULPS(R.z, (Vec3<Real>{0, -sin10<Real>, cos10<Real>}), 1);
    CHECK_EXACT(R.x, x<Real>);
}

TEST_CASE_TEMPLATE("cosine and sine are exact at the quarters, however often round", Real, EVERY_SCALAR) {
    struct Quarter {
        int degrees, c, s;
    };
    for (const Quarter& q : {Quarter{0, 1, 0}, Quarter{90, 0, 1}, Quarter{180, -1, 0}, Quarter{270, 0, -1},
                             Quarter{360, 1, 0}, Quarter{450, 0, 1}, Quarter{-90, 0, -1}, Quarter{-180, -1, 0},
                             Quarter{-270, 0, 1}, Quarter{3600, 1, 0}, Quarter{360090, 0, 1}}) {
        CAPTURE(q.degrees);
        const std::pair<Real, Real> cs = cos_sin(static_cast<Real>(q.degrees));
        CHECK_EXACT(cs.first, static_cast<Real>(q.c));
        CHECK_EXACT(cs.second, static_cast<Real>(q.s));
    }
}

TEST_CASE_TEMPLATE("cosine and sine of the angles that school knows", Real, EVERY_SCALAR) {
    const Real half = Real(0.5), root2 = std::sqrt(half), root3 = std::sqrt(Real(0.75));
    CHECK_ULPS(cos_sin(Real(60)).first, half, 2);
    CHECK_ULPS(cos_sin(Real(60)).second, root3, 2);
    CHECK_ULPS(cos_sin(Real(30)).second, half, 2);
    CHECK_ULPS(cos_sin(Real(45)).first, root2, 2);
    CHECK_ULPS(cos_sin(Real(135)).first, -root2, 2);
    CHECK_ULPS(cos_sin(Real(-120)).first, -half, 2);
    CHECK_ULPS(cos_sin(Real(-120)).second, -root3, 2);
}

TEST_CASE_TEMPLATE("quarter turns only exchange coordinates, to the bit", Real, EVERY_SCALAR) {
    for (const Real size : sizes<Real>) {
        const Vec3<Real> p{size * 3, Real(0.1), -7};
        CHECK_EXACT(turn<Real>(Axis::z, 90) * p, (Vec3<Real>{-p.y, p.x, p.z}));
        CHECK_EXACT(turn<Real>(Axis::y, 90) * p, (Vec3<Real>{p.z, p.y, -p.x}));
        CHECK_EXACT(turn<Real>(Axis::x, 90) * p, (Vec3<Real>{p.x, -p.z, p.y}));
        CHECK_EXACT(turn<Real>(Axis::z, 180) * p, (Vec3<Real>{-p.x, -p.y, p.z}));
        CHECK_EXACT(turn<Real>(Axis::z, -90) * p, (Vec3<Real>{p.y, -p.x, p.z}));
        CHECK_EXACT(turn<Real>(Axis::y, 360) * p, p);
    }
}

TEST_CASE_TEMPLATE("36 turns of 10 degrees are once round", Real, EVERY_SCALAR) {
    // Each composition rounds an entry three times (two products, a sum) of numbers of at most 1, and its own cosine
    // and sine once: at most 2 epsilon a step, 72 in all.
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
        const Rotation<Real> round = turns<Real>(std::vector<Turn<Real>>(36, {axis, 10}));
        CHECK_WITHIN(apart(round, Rotation<Real>{}), Real(0), 72 * epsilon<Real>);
    }
}

TEST_CASE_TEMPLATE("turns about one axis add up", Real, EVERY_SCALAR) {
    const std::vector<Turn<Real>> two{{Axis::z, 10}, {Axis::z, 25}};
    CHECK_WITHIN(apart(turns(two), turn<Real>(Axis::z, 35)), Real(0), 4 * epsilon<Real>);
    CHECK_EXACT(apart(turns<Real>({}), Rotation<Real>{}), Real(0));  // no turns, no rotation
}

TEST_CASE_TEMPLATE("turns about different axes do not commute: they come in the order given", Real, EVERY_SCALAR) {
    // about z first, x goes to y; then about x, y goes to z
    CHECK_EXACT(turns<Real>({{Axis::z, 90}, {Axis::x, 90}}) * x<Real>, z<Real>);
    // about x first, x stays; then about z, it goes to y
    CHECK_EXACT(turns<Real>({{Axis::x, 90}, {Axis::z, 90}}) * x<Real>, y<Real>);
    // R * S: first S, then R
    CHECK_EXACT((turn<Real>(Axis::x, 90) * turn<Real>(Axis::z, 90)) * x<Real>, z<Real>);
    // each about an axis of the world, not one that has turned along: y about z, after y has gone to z, stays
    CHECK_EXACT(turns<Real>({{Axis::x, 90}, {Axis::z, 90}}) * y<Real>, z<Real>);
}

TEST_CASE_TEMPLATE("a and s undo d and w", Real, EVERY_SCALAR) {
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
        for (const int degrees : {10, 37, 90, 180, 350}) {
            // c^2 + s^2 = 1 within two roundings and the errors of c and s
            const Rotation<Real> both = turn<Real>(axis, -degrees) * turn<Real>(axis, degrees);
            CHECK_WITHIN(apart(both, Rotation<Real>{}), Real(0), 3 * epsilon<Real>);
        }
    }
    // several are undone in the reverse order
    const Rotation<Real> all =
        turns<Real>({{Axis::z, 10}, {Axis::y, 20}, {Axis::x, 30}, {Axis::x, -30}, {Axis::y, -20}, {Axis::z, -10}});
    CHECK_WITHIN(apart(all, Rotation<Real>{}), Real(0), 16 * epsilon<Real>);
}

TEST_CASE_TEMPLATE("rotations keep lengths, angles and handedness", Real, EVERY_SCALAR) {
    Dice dice;
    for (int n = 0; n < 200; ++n) {
        const Rotation<Real> R = turns(some_turns<Real>(dice, 6));
        const Real most = 20 * epsilon<Real>;  // six compositions, 2 epsilon each, and the product's own
        CHECK_WITHIN(length(R.x), Real(1), most);
        CHECK_WITHIN(length(R.y), Real(1), most);
        CHECK_WITHIN(dot(R.x, R.y), Real(0), most);
        CHECK_WITHIN(length(cross(R.x, R.y) - R.z), Real(0), 2 * most);
    }
}

TEST_CASE_TEMPLATE("a rotation of a point of any size is right to a few ulps of its length", Real, EVERY_SCALAR) {
    Dice dice;
    for (const Real size : sizes<Real>) {
        const Vec3<Real> p = dice.vector(Real(1));
        const Rotation<Real> R = turns(some_turns<Real>(dice, 3));
        CHECK_EXACT(R * (size * p), size * (R * p));
        CHECK_ULPS(length(R * (size * p)), size * length(p), 12);
    }
}

TEST_CASE_TEMPLATE("points turn about the pivot, which stays", Real, EVERY_SCALAR) {
    const Vec3<Real> pivot{100, 350, 350};
    const Rotation<Real> about_y{-z<Real>, y<Real>, x<Real>};  // a quarter: z goes to x, and x to -z
    CHECK_EXACT(turned(pivot, quarter<Real>, pivot), pivot);
    CHECK_EXACT(turned(pivot + 5 * x<Real>, quarter<Real>, pivot), pivot + 5 * y<Real>);
    CHECK_EXACT(turned(pivot + 5 * z<Real>, about_y, pivot), pivot + 5 * x<Real>);
    CHECK_EXACT(turned(Vec3<Real>{500, 0, 0}, quarter<Real>, Vec3<Real>{}), (Vec3<Real>{0, 500, 0}));
}

TEST_CASE_TEMPLATE("a plane's corner turns about the pivot; its two steps only turn", Real, EVERY_SCALAR) {
    // The corner is 500 - 100 = 400 along x from the pivot and goes to 400 along y from it. A step from pixel to pixel
    // is the same wherever the pivot is: y goes to -x, z stays.
    const Vec3<Real> pivot{100, 20, 30};
    const ViewingPlane<Real> plane{{500, 20, 40}, {0, 2, 0}, {0, 0, 3}};
    const ViewingPlane<Real> got = turned(plane, quarter<Real>, pivot);
    CHECK_EXACT(got.corner, (Vec3<Real>{100, 420, 40}));
    CHECK_EXACT(got.right, (Vec3<Real>{-2, 0, 0}));
    CHECK_EXACT(got.up, (Vec3<Real>{0, 0, 3}));
}

TEST_CASE_TEMPLATE("a quarter turn of the paper's view: it looks along -y, from y = 500", Real, EVERY_SCALAR) {
    // (500, j, i) goes to (-j, 500, i), (-1, 0, 0) to (0, -1, 0)
    const Parallel<Real> view = turned(paper<Real>, quarter<Real>, Vec3<Real>{});
    for (const int j : {0, 123, 499}) {
        const Ray<Real> ray = pixel_ray(view, static_cast<Real>(j), 77);
        CHECK_EXACT(ray.P, (Vec3<Real>{static_cast<Real>(-j), 500, 77}));
        CHECK_EXACT(ray.D, (Vec3<Real>{0, -1, 0}));
    }
}

TEST_CASE_TEMPLATE("start points and direction turn together, by all the turns", Real, EVERY_SCALAR) {
    // The paper's program turns its start points by the last 10 degrees only, and the direction by all of them. After
    // two turns of 10 the start of pixel (0, 0) is 500 (cos 20, sin 20, 0), and its ray still aims at the origin.
    const Parallel<Real> view = turned(paper<Real>, turns<Real>({{Axis::z, 10}, {Axis::z, 10}}), Vec3<Real>{});
    const Ray<Real> ray = pixel_ray(view, 0, 0);
    const Real c = cos10<Real>, s = sin10<Real>;
    CHECK_ULPS(ray.P, 500 * (Vec3<Real>{c * c - s * s, 2 * s * c, 0}), 4);  // cos 2a, sin 2a
    CHECK_ULPS(ray.D, (Vec3<Real>{s * s - c * c, -2 * s * c, 0}), 4);
    CHECK_WITHIN(length(cross(ray.P, ray.D)), Real(0), 500 * 4 * epsilon<Real>);  // the line's distance from the origin
}

TEST_CASE_TEMPLATE("a turned view's ray is the view's ray turned, through every pixel", Real, EVERY_SCALAR) {
    Dice dice;
    for (int n = 0; n < 50; ++n) {
        const Rotation<Real> R = turns(some_turns<Real>(dice, 4));
        const Vec3<Real> pivot = dice.vector(Real(100));
        const Real j = static_cast<Real>(dice.whole(0, 499)), i = static_cast<Real>(dice.whole(0, 499));
        const Ray<Real> plain = pixel_ray(paper<Real>, j, i);
        const Ray<Real> ray = pixel_ray(turned(paper<Real>, R, pivot), j, i);
        CHECK_WITHIN(length(ray.P - turned(plain.P, R, pivot)), Real(0), 8000 * epsilon<Real>);  // 8 epsilon of 1000
        CHECK_EXACT(ray.D, R * plain.D);
    }
}

TEST_CASE_TEMPLATE("a pinhole's eye turns with its plane: t = 1 stays on the plane", Real, EVERY_SCALAR) {
    // the eye (1000, 250, 250) goes to (-250, 1000, 250), the plane's (500, j, i) to (-j, 500, i)
    const Pinhole<Real> view = turned(pinhole<Real>, quarter<Real>, Vec3<Real>{});
    for (const int j : {0, 250, 499}) {
        const Ray<Real> ray = pixel_ray(view, static_cast<Real>(j), 77);
        CHECK_EXACT(ray.P, (Vec3<Real>{-250, 1000, 250}));
        CHECK_EXACT(at(ray, 1), (Vec3<Real>{static_cast<Real>(-j), 500, 77}));
    }
    // about any pivot the ray keeps its length: eye and plane keep their distance
    const Vec3<Real> pivot{100, 350, 350};
    const Ray<Real> plain = pixel_ray(pinhole<Real>, 20, 30);
    const Ray<Real> ray = pixel_ray(turned(pinhole<Real>, turns<Real>({{Axis::z, 10}, {Axis::y, 20}}), pivot), 20, 30);
    CHECK_WITHIN(length(ray.D), length(plain.D), 8000 * epsilon<Real>);
}
