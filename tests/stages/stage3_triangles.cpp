// Stage 3: side products, which of them is the weight of which vertex, and which points belong to a triangle.
#include <algorithm>
#include <moeller_trumbore.hpp>
#include <probe.hpp>
#include <tolerance.hpp>
#include <vector>

#include "checks.hpp"
#include "unsure.hpp"

using namespace glassbox;
using namespace glassbox::test;

namespace {

template <class Real, class Rule>
Crossing<Real> shoot(const Ray<Real>& ray, const Triangle<Real>& triangle, const Rule& rule) {
    CAPTURE_RAY(ray, triangle);
    Silent silent;
    return intersect(ray, triangle, rule, silent);
}

/// A probe that keeps what the tolerance rule reports.
template <class Real>
struct DeficitProbe {
    Real sum{}, deficit{};

    template <class What, class... Values>
    void operator()(What, const Values&...) {}
    void operator()(told::Deficit, const Real& s, const Real& d) { sum = s, deficit = d; }
};

/// A probe that keeps what Plücker's test reports, and counts how often.
template <class Real>
struct TriangleProbe {
    int tested = 0, corners = 0, sides = 0;
    Vec3<Real> A, D;
    Real a{}, b{}, c{};

    template <class What, class... Values>
    void operator()(What, const Values&...) {}
    void operator()(told::Tested) { ++tested; }
    void operator()(told::Corners, const Triangle<Real>& seen, const Vec3<Real>& d) { ++corners, A = seen.A, D = d; }
    void operator()(told::Sides, const Real& x, const Real& y, const Real& z) { ++sides, a = x, b = y, c = z; }
};

template <class Real>
Triangle<Real> scaled(Real size, const Triangle<Real>& triangle) {
    return {size * triangle.A, size * triangle.B, size * triangle.C};
}

template <class Real>
Triangle<Real> other_winding(const Triangle<Real>& triangle) {
    return {triangle.A, triangle.C, triangle.B};
}

/// A triangle in general position, and a start off its plane and above no vertex in particular.
template <class Real>
const Triangle<Real> slanting{{1, 2, 3}, {5, -1, 4}, {2, 6, -2}};
template <class Real>
const Vec3<Real> start{10, 11, 12};

/// The direction from `start` to a point given by whole weights of the slanting triangle's vertices, times their sum so
/// that it is whole, too: (a A + b B + c C) - (a + b + c) P.
template <class Real>
Vec3<Real> towards_weights(Real a, Real b, Real c) {
    const auto& [A, B, C] = slanting<Real>;
    return a * A + b * B + c * C - (a + b + c) * start<Real>;
}

/// The side products of the ray to that point.
template <class Real>
Sides<Real> sides_towards(Real a, Real b, Real c) {
    const Ray<Real> ray{start<Real>, towards_weights(a, b, c)};
    CAPTURE_RAY(ray, slanting<Real>);
    return sides(ray.D, seen_from(ray.P, slanting<Real>));
}

/// The right-angled triangle of side 4 in the plane z = 0.
template <class Real>
const Triangle<Real> flat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

/// The ray that falls straight down on (x, y).
template <class Real>
Ray<Real> down(Real x, Real y) {
    return {{x, y, 8}, {0, 0, -1}};
}

}  // namespace

TEST_CASE_TEMPLATE("a side product tells on which side ray and edge pass, and 0 where they meet", Real, EVERY_SCALAR) {
    const Vec3<Real> up{0, 0, 1};
    // D.(B x A): from A = (1,0,5) to B = (0,1,5), counter-clockwise about the ray: B.x*A.y - B.y*A.x = 0*0 - 1*1 = -1
    CHECK_EXACT(side(up, Vec3<Real>{1, 0, 5}, Vec3<Real>{0, 1, 5}), Real(-1));
    // the same edge run the other way, clockwise: 1*1 - 0*0 = 1
    CHECK_EXACT(side(up, Vec3<Real>{0, 1, 5}, Vec3<Real>{1, 0, 5}), Real(1));
    // the edge from (-1,0,5) to (1,0,5) crosses the ray
    CHECK_EXACT(side(up, Vec3<Real>{-1, 0, 5}, Vec3<Real>{1, 0, 5}), Real(0));
    // so do parallels, at infinity
    CHECK_EXACT(side(up, Vec3<Real>{3, 4, 5}, Vec3<Real>{3, 4, 7}), Real(0));
}

TEST_CASE_TEMPLATE("a side product is |D| |AB| distance sin(angle): length^2 |D|", Real, EVERY_SCALAR) {
    // An edge of length 2 along y, 3 beside the ray, at right angles to it, seen from the left: -(1 * 2 * 3 * 1) = -6
    const Vec3<Real> up{0, 0, 1}, A{3, 0, 7}, B{3, 2, 7};
    CHECK_EXACT(side(up, A, B), Real(-6));
    for (const Real size : sizes<Real>) {
        CAPTURE(size);
        CHECK_EXACT(side(size * up, A, B), -6 * size);
        CHECK_EXACT(side(up, size * A, size * B), -6 * size * size);
    }
}

TEST_CASE_TEMPLATE("an edge run the other way has the opposite side product, to the bit", Real, EVERY_SCALAR) {
    // B x A = -(A x B) to the bit, and minus passes through products and sums unchanged.
    Dice dice;
    for (const Real size : sizes<Real>) {
        CAPTURE(size);
        for (int n = 0; n < 1000; ++n) {
            const Vec3<Real> D = dice.vector(Real(1)), A = dice.vector(size), B = A + dice.vector(size / 1000);
            CHECK_EXACT(side(D, A, B), -side(D, B, A));
        }
    }
}

TEST_CASE_TEMPLATE("the normal: counter-clockwise vertices look at you", Real, EVERY_SCALAR) {
    // the paper's example: (0,1,0), (0,0,0), (1,0,0) has its normal along z:
    // (B - A) x (C - A) = (0,-1,0) x (1,-1,0) = (0, 0, 0*(-1) - (-1)*1) = (0, 0, 1)
    const Triangle<Real> example{{0, 1, 0}, {0, 0, 0}, {1, 0, 0}};
    for (const Real size : sizes<Real>) {
        // |n|^2 is of the size's fourth power, and float ends at 3e38
        if (std::is_same_v<Real, float> && size > Real(1e9)) continue;
        CHECK_EXACT(normal(scaled(size, example)), (Vec3<Real>{0, 0, 1}));
        CHECK_EXACT(normal(other_winding(scaled(size, example))), (Vec3<Real>{0, 0, -1}));
    }
    const Vec3<Real> none = normal(Triangle<Real>{{1, 1, 1}, {2, 2, 2}, {3, 3, 3}});
    CHECK(std::isnan(none.x));
}

TEST_CASE_TEMPLATE("the normal: it does not change when the triangle moves, and stands at right angles to all edges",
                   Real, EVERY_SCALAR) {
    // (B - A) x (C - A) = (4,-3,1) x (1,4,-5) = (15 - 4, 1 + 20, 16 + 3) = (11, 21, 19), of length sqrt 923
    const Vec3<Real> expected = Vec3<Real>{11, 21, 19} / std::sqrt(Real(923));
    CHECK_ULPS(normal(slanting<Real>), expected, 2);
    const auto& [A, B, C] = slanting<Real>;
    const Vec3<Real> move{1000, -2000, 3000};
    CHECK_ULPS(normal(Triangle<Real>{A + move, B + move, C + move}), expected, 2);
}

TEST_CASE_TEMPLATE("seen from P, a triangle is where P is the origin", Real, EVERY_SCALAR) {
    // (1,2,3) - (10,11,12), (5,-1,4) - (10,11,12), (2,6,-2) - (10,11,12)
    const Triangle<Real> seen = seen_from(start<Real>, slanting<Real>);
    CHECK_EXACT(seen.A, (Vec3<Real>{-9, -9, -9}));
    CHECK_EXACT(seen.B, (Vec3<Real>{-5, -12, -8}));
    CHECK_EXACT(seen.C, (Vec3<Real>{-8, -5, -14}));
}

TEST_CASE_TEMPLATE("sides: a is with the edge BC, b with CA, c with AB, each run this way", Real, EVERY_SCALAR) {
    // (0, 0, 0), (6, 0, 0), (0, 6, 0), seen from (1, 2, 1), and D straight down. A side D.(B x A) is here minus the z
    // of the cross product, B.y*A.x - B.x*A.y:
    //   a = C.y*B.x - C.x*B.y = 4*5 - (-1)*(-2) = 18,  b = A.y*C.x - A.x*C.y = (-2)*(-1) - (-1)*4 = 6,
    //   c = B.y*A.x - B.x*A.y = (-2)*(-1) - 5*(-2) = 12
    const Sides<Real> s = sides(Vec3<Real>{0, 0, -1}, Triangle<Real>{{-1, -2, -1}, {5, -2, -1}, {-1, 4, -1}});
    CHECK_EXACT(s.a, Real(18));
    CHECK_EXACT(s.b, Real(6));
    CHECK_EXACT(s.c, Real(12));
}

TEST_CASE_TEMPLATE("each side is the weight of the vertex opposite: at a vertex its own alone is not 0", Real,
                   EVERY_SCALAR) {
    // All numbers are whole and below 2^24, so the zeros are exact.
    const Sides<Real> at_A = sides_towards<Real>(1, 0, 0);
    CHECK(at_A.a != 0);
    CHECK_EXACT(at_A.b, Real(0));
    CHECK_EXACT(at_A.c, Real(0));
    const Sides<Real> at_B = sides_towards<Real>(0, 1, 0);
    CHECK_EXACT(at_B.a, Real(0));
    CHECK(at_B.b != 0);
    CHECK_EXACT(at_B.c, Real(0));
    const Sides<Real> at_C = sides_towards<Real>(0, 0, 1);
    CHECK_EXACT(at_C.a, Real(0));
    CHECK_EXACT(at_C.b, Real(0));
    CHECK(at_C.c != 0);
}

TEST_CASE_TEMPLATE("on an edge the opposite weight is 0, and the others divide it", Real, EVERY_SCALAR) {
    const Sides<Real> on_BC = sides_towards<Real>(0, 1, 3);  // three quarters of the way from B to C
    CHECK_EXACT(on_BC.a, Real(0));
    CHECK_EXACT(on_BC.c, 3 * on_BC.b);
    const Sides<Real> on_CA = sides_towards<Real>(2, 0, 1);
    CHECK_EXACT(on_CA.b, Real(0));
    CHECK_EXACT(on_CA.a, 2 * on_CA.c);
    const Sides<Real> on_AB = sides_towards<Real>(1, 1, 0);
    CHECK_EXACT(on_AB.c, Real(0));
    CHECK_EXACT(on_AB.a, on_AB.b);
}

TEST_CASE_TEMPLATE("inside, the sides stand to each other as the weights of the point hit", Real, EVERY_SCALAR) {
    const Sides<Real> s = sides_towards<Real>(1, 2, 3);
    CHECK_EXACT(s.b, 2 * s.a);
    CHECK_EXACT(s.c, 3 * s.a);
}

TEST_CASE_TEMPLATE("inside: no two of the three signs are opposite, and not all are 0", Real, EVERY_SCALAR) {
    const auto is_inside = [](Real a, Real b, Real c) { return inside(Sides<Real>{a, b, c}); };
    CHECK(is_inside(1, 2, 3));
    CHECK(is_inside(-1, -2, -3));       // seen from behind
    CHECK(is_inside(0, 2, 3));          // on an edge
    CHECK(is_inside(0, 0, -3));         // at a vertex
    CHECK_FALSE(is_inside(0, 0, 0));    // edge-on, or no area
    CHECK_FALSE(is_inside(-1, 2, 3));   // beyond one edge
    CHECK_FALSE(is_inside(-1, -2, 3));  // beyond two
    for (const Real a : {Real(-1), Real(0), Real(1)})
        for (const Real b : {Real(-1), Real(0), Real(1)})
            for (const Real c : {Real(-1), Real(0), Real(1)}) {
                CAPTURE(a);
                CAPTURE(b);
                CAPTURE(c);
                const bool has_positive = a > 0 || b > 0 || c > 0, has_negative = a < 0 || b < 0 || c < 0;
                CHECK(is_inside(a, b, c) == (has_positive != has_negative));
            }
}

TEST_CASE("inside: where a sign is undecided, so is the answer, unless the others settle it") {
    const auto is_inside = [](double a, double b, double c) { return inside(Sides<Unsure>{a, b, c}); };
    // each number is known to within 1
    CHECK(surely(is_inside(2, 3, 4)));
    CHECK_FALSE(possibly(is_inside(2, -3, 4)));
    CHECK_FALSE(possibly(is_inside(2, -3, 0.5)));  // miss, whatever the third sign is
    for (const auto& undecided : {is_inside(0.5, 3, 4), is_inside(-0.5, 3, 4), is_inside(0, -3, -4)}) {
        CHECK(possibly(undecided));
        CHECK_FALSE(surely(undecided));
    }
}

TEST_CASE_TEMPLATE("plane_t: with the triangle in the plane z = 8 a ray along z meets it at 8 / D.z", Real,
                   EVERY_SCALAR) {
    // all corners are equally far along D: whatever the weights, their mean is, too
    const Triangle<Real> seen{{-1, -1, 8}, {3, -1, 8}, {-1, 3, 8}};
    CHECK_EXACT(plane_t(Vec3<Real>{0, 0, 1}, seen, Sides<Real>{1, 1, 1}), Real(8));
    CHECK_EXACT(plane_t(Vec3<Real>{0, 0, 1}, seen, Sides<Real>{-2, -1, -1}), Real(8));
    CHECK_EXACT(plane_t(Vec3<Real>{0, 0, 2}, seen, Sides<Real>{1, 2, 1}), Real(4));
    CHECK_EXACT(plane_t(Vec3<Real>{0, 0, -2}, seen, Sides<Real>{1, 2, 1}), Real(-4));
    // 8 / (1/3): 1/3 is rounded, and each product, sum and quotient after it
    CHECK_ULPS(plane_t(Vec3<Real>{0, 0, Real(1) / 3}, seen, Sides<Real>{1, 1, 1}), Real(24), 8);
}

TEST_CASE_TEMPLATE("plane_t: each weight pulls towards its own vertex", Real, EVERY_SCALAR) {
    // corners at 2, 4 and 8 along D: (1*2 + 2*4 + 1*8) / 4 = 4.5; each alone gives its own
    const Triangle<Real> seen{{5, 1, 2}, {-7, 3, 4}, {6, 6, 8}};
    const Vec3<Real> D{0, 0, 1};
    CHECK_EXACT(plane_t(D, seen, Sides<Real>{1, 2, 1}), Real(4.5));
    CHECK_EXACT(plane_t(D, seen, Sides<Real>{3, 0, 0}), Real(2));
    CHECK_EXACT(plane_t(D, seen, Sides<Real>{0, -3, 0}), Real(4));
    CHECK_EXACT(plane_t(D, seen, Sides<Real>{0, 0, 5}), Real(8));
}

TEST_CASE_TEMPLATE("plane_t: D.A is divided by D.D before it is multiplied by a, and large numbers stay numbers", Real,
                   EVERY_SCALAR) {
    // In double, corners of size 1e48 and a D of 1e96: the weights are of size 1e192, D.A is 1e145, and their product
    // is too large for a double. D.A / D.D is 1e-48, though, and times a weight 1e145. The triangle is at z = 8, as
    // above.
    const int power = std::numeric_limits<Real>::max_exponent / 32 * 5;
    const Real size = std::ldexp(Real(1), power), long_D = size * size;
    const Triangle<Real> seen = scaled(size, Triangle<Real>{{-1, -1, 8}, {3, -1, 8}, {-1, 3, 8}});
    const Real weight = long_D * size * size;
    CHECK_EXACT(plane_t(Vec3<Real>{0, 0, long_D}, seen, Sides<Real>{weight, 2 * weight, weight}), 8 / size);
}

TEST_CASE_TEMPLATE("by the sides of its own ray, plane_t of the point with weights 1, 2, 3 is 1/6", Real,
                   EVERY_SCALAR) {
    // D is 6 times the way to the point: t = 1/6, after one division and a few sums
    const Vec3<Real> D = towards_weights<Real>(1, 2, 3);
    const Sides<Real> weights = sides_towards<Real>(1, 2, 3);
    CHECK_ULPS(plane_t(D, seen_from(start<Real>, slanting<Real>), weights), Real(1) / 6, 4);
}

TEST_CASE_TEMPLATE("the three rules agree about the point with weights 1, 2, 3", Real, EVERY_SCALAR) {
    const Ray<Real> ray{start<Real>, towards_weights<Real>(1, 2, 3)};
    for (const Crossing<Real>& crossing :
         {shoot(ray, slanting<Real>, Pluecker{}), shoot(ray, slanting<Real>, MoellerTrumbore{}),
          shoot(ray, slanting<Real>, Tolerance{})}) {
        CHECK(crossing.met);
        CHECK_ULPS(crossing.t, Real(1) / 6, 4);
    }
}

TEST_CASE_TEMPLATE("Pluecker: the probe is told the corners and the sides", Real, EVERY_SCALAR) {
    TriangleProbe<Real> probe;
    const Ray<Real> ray{start<Real>, towards_weights<Real>(1, 2, 3)};
    CAPTURE_RAY(ray, slanting<Real>);
    intersect(ray, slanting<Real>, Pluecker{}, probe);
    CHECK(probe.tested == 1);
    CHECK(probe.corners == 1);
    CHECK(probe.sides == 1);
    CHECK_EXACT(probe.A, (Vec3<Real>{-9, -9, -9}));  // as seen from the ray's start
    CHECK_EXACT(probe.D, ray.D);
    const Sides<Real> expected = sides(ray.D, seen_from(start<Real>, slanting<Real>));
    CHECK_EXACT(probe.a, expected.a);
    CHECK_EXACT(probe.b, expected.b);
    CHECK_EXACT(probe.c, expected.c);
    // and where the ray misses, too: that is what the overlays of near misses show
    intersect(Ray<Real>{start<Real>, towards_weights<Real>(-1, 4, 4)}, slanting<Real>, Pluecker{}, probe);
    CHECK(probe.sides == 2);
}

TEST_CASE_TEMPLATE("the hit point is the vertices' mean by the sides' weights, and lies at t on the ray", Real,
                   EVERY_SCALAR) {
    Dice dice;
    for (const Real size : sizes<Real>) {
        CAPTURE(size);
        for (int n = 0; n < 300; ++n) {
            const Triangle<Real> triangle{dice.vector(size), dice.vector(size), dice.vector(size)};
            const auto& [A, B, C] = triangle;
            // weights of at least 1/7 each, in all directions: well inside
            const Real u = dice.between(Real(1), Real(3)), v = dice.between(Real(1), Real(3)), w = Real(1);
            const Vec3<Real> goal = (u * A + v * B + w * C) / (u + v + w);
            const Vec3<Real> P = dice.vector(2 * size);
            const Real stretch = dice.between(Real(0.25), Real(4));
            const Ray<Real> ray{P, stretch * unit(goal - P)};
            // a triangle seen nearly edge-on has no weights to speak of: leave out what is under 3 degrees
            const Vec3<Real> n_AB = cross(B - A, C - A);
            const Real steep = std::abs(dot(unit(n_AB), unit(ray.D)));
            if (!(steep > Real(0.05)) || length(n_AB) < size * size / 20) continue;
            const Sides<Real> s = sides(ray.D, seen_from(P, triangle));
            const Vec3<Real> mean = (s.a * A + s.b * B + s.c * C) / (s.a + s.b + s.c);
            const Crossing<Real> crossing = shoot(ray, triangle, Pluecker{});
            CHECK(crossing.met);
            // The sides' errors, 4 epsilon times 3 sizes squared each, against a sum of steep * |n| >= size^2 / 400.
            const Real most = 20000 * epsilon<Real> * size;
            CHECK_WITHIN(length(mean - goal), Real(0), most);
            CHECK_WITHIN(length(at(ray, crossing.t) - mean), Real(0), most);
            CHECK_WITHIN(length(at(ray, crossing.t) - goal), Real(0), most);
        }
    }
}

TEST_CASE_TEMPLATE("vertices and edges belong to the triangle, from both sides and for both windings", Real,
                   EVERY_SCALAR) {
    for (const Real turn_up : {Real(1), Real(-1)}) {
        for (const Triangle<Real>& triangle : {flat<Real>, other_winding(flat<Real>)}) {
            const auto hit = [&](Real x, Real y) {
                const Ray<Real> ray{{x, y, 8 * turn_up}, {0, 0, -turn_up}};
                const Crossing<Real> crossing = shoot(ray, triangle, Pluecker{});
                if (crossing.met) CHECK_EXACT(crossing.t, Real(8));
                return crossing.met;
            };
            CHECK(hit(0, 0));  // the vertices
            CHECK(hit(4, 0));
            CHECK(hit(0, 4));
            CHECK(hit(2, 0));  // the edges' middles
            CHECK(hit(2, 2));
            CHECK(hit(0, 2));
            CHECK(hit(1, 1));                  // inside
            CHECK_FALSE(hit(Real(2.125), 2));  // and an eighth beyond each edge
            CHECK_FALSE(hit(2, Real(-0.125)));
            CHECK_FALSE(hit(Real(-0.125), 2));
            CHECK_FALSE(hit(Real(4.125), 0));  // and beyond each vertex
            CHECK_FALSE(hit(0, Real(4.125)));
            CHECK_FALSE(hit(Real(-0.125), Real(-0.125)));
        }
    }
}

TEST_CASE_TEMPLATE("vertices and edges belong to a slanting triangle, too", Real, EVERY_SCALAR) {
    struct Weights {
        Real a, b, c;
    };
    for (const Weights& w :
         {Weights{1, 0, 0}, Weights{0, 1, 0}, Weights{0, 0, 1}, Weights{1, 1, 0}, Weights{0, 1, 3}, Weights{2, 0, 1}}) {
        const Ray<Real> ray{start<Real>, towards_weights(w.a, w.b, w.c)};
        const Crossing<Real> crossing = shoot(ray, slanting<Real>, Pluecker{});
        CHECK(crossing.met);
        CHECK_ULPS(crossing.t, 1 / (w.a + w.b + w.c), 4);
    }
    // one weight below 0: outside, beyond the opposite edge
    for (const Weights& w : {Weights{-1, 4, 4}, Weights{4, -1, 4}, Weights{4, 4, -1}}) {
        CHECK_FALSE(shoot({start<Real>, towards_weights(w.a, w.b, w.c)}, slanting<Real>, Pluecker{}).met);
        CHECK_FALSE(shoot({start<Real>, towards_weights(w.a, w.b, w.c)}, slanting<Real>, MoellerTrumbore{}).met);
    }
}

TEST_CASE_TEMPLATE("only ahead: a triangle behind the start, or through it, is not met", Real, EVERY_SCALAR) {
    const auto met = [](const Ray<Real>& ray) {
        CHECK(shoot(ray, flat<Real>, Pluecker{}).met == shoot(ray, flat<Real>, MoellerTrumbore{}).met);
        return shoot(ray, flat<Real>, Pluecker{}).met;
    };
    CHECK(met({{1, 1, 8}, {0, 0, -1}}));
    CHECK_FALSE(met({{1, 1, 8}, {0, 0, 1}}));
    CHECK_FALSE(met({{1, 1, 0}, {0, 0, 1}}));  // t = 0 is no hit
    CHECK_FALSE(met({{1, 1, 0}, {1, 2, 3}}));
}

TEST_CASE_TEMPLATE("seen edge-on a triangle is never met", Real, EVERY_SCALAR) {
    for (const Vec3<Real>& D : {Vec3<Real>{1, 0, 0}, Vec3<Real>{3, 2, 0}, Vec3<Real>{1, 1, 0}}) {
        // along its own plane, from outside through the middle, along an edge, and beside it
        for (const Real y : {Real(1), Real(0), Real(-1)}) {
            CHECK_FALSE(shoot({{-8, y, 0}, D}, flat<Real>, Pluecker{}).met);
            CHECK_FALSE(shoot({{-8, y, 0}, D}, flat<Real>, Tolerance{}).met);
            CHECK_FALSE(shoot({{-8, y, 0}, D}, flat<Real>, MoellerTrumbore{}).met);
        }
        CHECK_FALSE(shoot({{-8, 1, 1}, D}, flat<Real>, Pluecker{}).met);  // parallel to it, 1 above
    }
}

TEST_CASE_TEMPLATE("a triangle without area is never met", Real, EVERY_SCALAR) {
    const Vec3<Real> A{1, 2, 3}, along{2, -1, 1};
    // three points of one line, in any order; a ray through the line
    for (const Triangle<Real>& line :
         {Triangle<Real>{A, A + along, A + 3 * along}, Triangle<Real>{A + along, A, A + 3 * along},
          Triangle<Real>{A + 3 * along, A + along, A}}) {
        for (const Vec3<Real>& goal : {A, A + along, A + 2 * along, A + 3 * along}) {
            CHECK_FALSE(shoot({start<Real>, goal - start<Real>}, line, Pluecker{}).met);
        }
    }
    // two or three equal vertices: BA and AB have opposite sides to the bit, whatever the numbers
    Dice dice;
    for (const Real size : sizes<Real>) {
        for (int n = 0; n < 200; ++n) {
            const Vec3<Real> P = dice.vector(size), Q = dice.vector(size);
            const Ray<Real> ray{dice.vector(size), dice.vector(Real(1))};
            CHECK_FALSE(shoot(ray, {P, P, Q}, Pluecker{}).met);
            CHECK_FALSE(shoot(ray, {P, Q, P}, Pluecker{}).met);
            CHECK_FALSE(shoot(ray, {Q, P, P}, Pluecker{}).met);
            CHECK_FALSE(shoot(Ray<Real>{ray.P, P - ray.P}, {P, P, Q}, Pluecker{}).met);
            CHECK_FALSE(shoot(Ray<Real>{ray.P, P - ray.P}, {P, P, P}, Pluecker{}).met);
        }
    }
}

TEST_CASE_TEMPLATE("the winding decides about the normal, not about the hit", Real, EVERY_SCALAR) {
    Dice dice;
    int hits = 0;
    for (const Real size : sizes<Real>) {
        for (int n = 0; n < 400; ++n) {
            const Triangle<Real> triangle{dice.vector(size), dice.vector(size), dice.vector(size)};
            const Vec3<Real> P = dice.vector(2 * size);
            const Vec3<Real> goal = (triangle.A + triangle.B + triangle.C) / 3 + dice.vector(size / 4);
            const Ray<Real> ray{P, unit(goal - P)};
            const Crossing<Real> one = shoot(ray, triangle, Pluecker{});
            const Crossing<Real> other = shoot(ray, other_winding(triangle), Pluecker{});
            CHECK(one.met == other.met);
            hits += one.met;
        }
    }
    CHECK(hits > 500);
}

TEST_CASE_TEMPLATE("a scene of any size, a D of any length: not a bit changes but in t's scale", Real, EVERY_SCALAR) {
    Dice dice;
    for (const Real size : sizes<Real>) {
        CAPTURE(size);
        for (int n = 0; n < 200; ++n) {
            const Triangle<Real> triangle{dice.vector(Real(1)), dice.vector(Real(1)), dice.vector(Real(1))};
            const auto& [A, B, C] = triangle;
            const Vec3<Real> P = dice.vector(Real(2)), D = (A + B + C) / 3 + dice.vector(Real(0.5)) - P;
            const Crossing<Real> here = shoot({P, D}, triangle, Pluecker{});
            const Crossing<Real> larger = shoot({size * P, D}, scaled(size, triangle), Pluecker{});
            const Crossing<Real> longer = shoot({P, size * D}, triangle, Pluecker{});
            CHECK(larger.met == here.met);
            CHECK(longer.met == here.met);
            CHECK_EXACT(larger.t, size * here.t);
            CHECK_EXACT(longer.t, here.t / size);
        }
    }
}

TEST_CASE_TEMPLATE("moving ray and triangle together changes nothing", Real, EVERY_SCALAR) {
    // whole numbers move by whole numbers without rounding, and only A - P, B - P, C - P are ever used
    Dice dice;
    for (int n = 0; n < 300; ++n) {
        const Triangle<Real> triangle{dice.whole_vector<Real>(50), dice.whole_vector<Real>(50),
                                      dice.whole_vector<Real>(50)};
        const Ray<Real> ray{dice.whole_vector<Real>(100), dice.vector(Real(1))};
        const Vec3<Real> move = dice.whole_vector<Real>(1000000);
        const Crossing<Real> here = shoot(ray, triangle, Pluecker{});
        const Crossing<Real> there = shoot(
            {ray.P + move, ray.D}, Triangle<Real>{triangle.A + move, triangle.B + move, triangle.C + move}, Pluecker{});
        CHECK(there.met == here.met);
        CHECK_EXACT(there.t, here.t);
    }
}

TEST_CASE_TEMPLATE("no ray slips between two triangles that share an edge", Real, EVERY_SCALAR) {
    // The two see opposite numbers at the shared edge, so at least one of them says >= 0 where it must. Each ray is
    // aimed at a point of the edge VR between the fan's triangles, as near as the scalar can say.
    Dice dice;
    int lost = 0;
    for (const Real size : sizes<Real>) {
        for (int n = 0; n < 20000; ++n) {
            const Vec3<Real> V = dice.vector(size), R = dice.vector(size);
            const Vec3<Real> beside = cross(R - V, dice.vector(Real(1)));
            const Vec3<Real> left = (V + R) / 2 + beside, right = (V + R) / 2 - beside;
            const Vec3<Real> goal = V + dice.between(Real(0.01), Real(0.99)) * (R - V);
            const Vec3<Real> P = goal + cross(R - V, beside) / size + dice.vector(size / 10);
            const Ray<Real> ray{P, unit(goal - P)};
            lost += !shoot(ray, {V, R, left}, Pluecker{}).met && !shoot(ray, {R, V, right}, Pluecker{}).met;
        }
    }
    CHECK(lost == 0);
}

TEST_CASE_TEMPLATE("a closed mesh is closed: from inside, no ray escapes through its edges", Real, EVERY_SCALAR) {
    // An octahedron, scaled and moved, and its twelve edges.
    const Vec3<Real> c{Real(0.3), Real(-0.7), Real(0.2)};
    const std::array<Vec3<Real>, 6> v{c + Vec3<Real>{1, 0, 0},  c + Vec3<Real>{0, 1, 0},  c + Vec3<Real>{0, 0, 1},
                                      c + Vec3<Real>{-1, 0, 0}, c + Vec3<Real>{0, -1, 0}, c + Vec3<Real>{0, 0, -1}};
    std::vector<Triangle<Real>> faces;
    std::vector<std::array<Vec3<Real>, 2>> edges;
    for (const std::size_t x : {0u, 3u}) {
        for (const std::size_t y : {1u, 4u}) {
            edges.push_back({v[x], v[y]});
            for (const std::size_t z : {2u, 5u}) faces.push_back({v[x], v[y], v[z]});
        }
        for (const std::size_t z : {2u, 5u}) edges.push_back({v[x], v[z]});
    }
    for (const std::size_t y : {1u, 4u}) {
        for (const std::size_t z : {2u, 5u}) edges.push_back({v[y], v[z]});
    }
    Dice dice;
    int lost = 0;
    for (const auto& [A, B] : edges) {
        for (int n = 0; n < 3000; ++n) {
            const Vec3<Real> P = c + dice.vector(Real(0.3));  // inside: |x| + |y| + |z| < 1
            const Vec3<Real> goal = A + dice.between(Real(0.01), Real(0.99)) * (B - A);
            int hits = 0;
            for (const Triangle<Real>& face : faces) hits += shoot({P, goal - P}, face, Pluecker{}).met;
            lost += hits == 0;
        }
    }
    CHECK(lost == 0);
}

TEST_CASE_TEMPLATE("at a vertex opposite signs are not enough: a lost ray there is one that rounding cannot tell", Real,
                   EVERY_SCALAR) {
    // Aimed at the middle of a fan, a ray's side products with the spokes are all nearly 0. Each spoke's two triangles
    // agree about it, yet the spokes, each rounded for itself, may all say "left": then no triangle is hit. Such a ray
    // has every spoke within its error bound: |s computed - s| <= 4 epsilon P, P the same sum of absolute values.
    Dice dice;
    int lost = 0;
    Real worst = 0;
    for (int n = 0; n < 20000; ++n) {
        const Vec3<Real> V = dice.vector(Real(1)), P = V + Vec3<Real>{0, 0, 3} + dice.vector(Real(0.3));
        const std::array<Vec3<Real>, 3> rim{V + Vec3<Real>{1, 0, 0}, V + Vec3<Real>{-1, 1, 0},
                                            V + Vec3<Real>{-1, -1, 0}};
        const Vec3<Real> D = V - P;
        int hits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            hits += shoot(Ray<Real>{P, D}, {V, rim[k], rim[(k + 1) % 3]}, Pluecker{}).met;
        if (hits > 0) continue;
        ++lost;
        for (const Vec3<Real>& R : rim) {
            const Vec3<Real> A = V - P, B = R - P;
            const Real size = std::abs(D.x) * (std::abs(B.y * A.z) + std::abs(B.z * A.y)) +
                              std::abs(D.y) * (std::abs(B.z * A.x) + std::abs(B.x * A.z)) +
                              std::abs(D.z) * (std::abs(B.x * A.y) + std::abs(B.y * A.x));
            worst = std::max(worst, std::abs(side(D, A, B)) / (4 * epsilon<Real> * size));
        }
    }
    CHECK(worst <= 1);  // one check, not one per ray: a wrong `side` would fail tens of thousands of times
    CHECK(lost > 0);
    CHECK(lost < 20000 / 4);  // three signs that fall as they like agree in one case of four
}

TEST_CASE_TEMPLATE("the tolerance takes a clear miss of a small triangle for a hit", Real, EVERY_SCALAR) {
    // The ray falls at (2, 2); the triangle ends at x + y = 1. Seen from (2,2,1): A = (-2,-2,-1), B = (-1,-2,-1),
    // C = (-2,-1,-1), and D.(B x A) = -(B.x A.y - B.y A.x):
    //   a = -(C.x B.y - C.y B.x) = -(4 - 1) = -3,  b = -(A.x C.y - A.y C.x) = -(2 - 4) = 2,  c = -(2 - 4) = 2
    const Triangle<Real> small{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Ray<Real> ray{{2, 2, 1}, {0, 0, -1}};
    CAPTURE_RAY(ray, small);
    const Sides<Real> s = sides(ray.D, seen_from(ray.P, small));
    CHECK_EXACT(s.a, Real(-3));
    CHECK_EXACT(s.b, Real(2));
    CHECK_EXACT(s.c, Real(2));
    // sum 1, deficit |1 - 7| = 6, twice the smaller of 4 and 3: under 10
    DeficitProbe<Real> probe;
    CHECK(intersect(ray, small, Tolerance{}, probe).met);
    CHECK_EXACT(probe.sum, Real(1));
    CHECK_EXACT(probe.deficit, Real(6));
    CHECK_FALSE(shoot(ray, small, Tolerance{6.0}).met);  // "under", not "up to"
    CHECK_FALSE(shoot(ray, small, Pluecker{}).met);
    CHECK_FALSE(shoot(ray, small, MoellerTrumbore{}).met);
}

TEST_CASE_TEMPLATE("the deficit is twice the smaller of the positive and the negative part", Real, EVERY_SCALAR) {
    Dice dice;
    for (int n = 0; n < 500; ++n) {
        // whole numbers: all of it exact
        const Triangle<Real> triangle{dice.whole_vector<Real>(20), dice.whole_vector<Real>(20),
                                      dice.whole_vector<Real>(20)};
        const Ray<Real> ray{dice.whole_vector<Real>(20), dice.whole_vector<Real>(5)};
        const Sides<Real> s = sides(ray.D, seen_from(ray.P, triangle));
        Real positive = 0, negative = 0;
        for (const Real x : {s.a, s.b, s.c}) (x > 0 ? positive : negative) += std::abs(x);
        DeficitProbe<Real> probe;
        intersect(ray, triangle, Tolerance{}, probe);
        CHECK_EXACT(probe.deficit, 2 * std::min(positive, negative));
    }
}

TEST_CASE("the tolerance refuses good hits of a large triangle") {
    // Both rays are aimed at exactly the middle of the edge BC, which belongs to the triangle; every coordinate is an
    // integer. The true a is 0. Its terms are of size 1e29, so rounding may leave it anywhere within some 1e13, and
    // where it comes out below 0, twice its size is compared with a tolerance of 10.
    const Triangle<double> large{{0, 0, 0}, {1e10, 0, 0}, {0, 1e10, 0}};
    const Vec3<double> middle{5e9, 5e9, 0};
    int refused = 0;
    for (int n = 0; n < 100; ++n) {
        const Vec3<double> P{1e10, 5e9 + 7 * n, 1e9};
        const Ray<double> ray{P, middle - P};
        DeficitProbe<double> probe;
        if (intersect(ray, large, Tolerance{}, probe).met) continue;
        ++refused;
        CHECK(probe.deficit > 1e6);
        CHECK(sides(ray.D, seen_from(P, large)).a < 0);
    }
    CHECK(refused > 0);
}

TEST_CASE_TEMPLATE("== was never the fault: of one sign, the sum of sizes is the size of the sum, to the bit", Real,
                   EVERY_SCALAR) {
    Dice dice;
    for (const Real size : sizes<Real>) {
        for (int n = 0; n < 500; ++n) {
            const Real a = dice.between(Real(0), size), b = dice.between(Real(0), size),
                       c = dice.between(Real(0), Real(1));
            CHECK_EXACT(std::abs(a + b + c), std::abs(a) + std::abs(b) + std::abs(c));
            CHECK_EXACT(std::abs(-a - b - c), std::abs(-a) + std::abs(-b) + std::abs(-c));
        }
    }
}

TEST_CASE_TEMPLATE("Moeller and Trumbore agree with Pluecker, away from the edges", Real, EVERY_SCALAR) {
    Dice dice;
    int hits = 0, misses = 0;
    for (const Real size : sizes<Real>) {
        CAPTURE(size);
        for (int n = 0; n < 2000; ++n) {
            const Triangle<Real> triangle{dice.vector(size), dice.vector(size), dice.vector(size)};
            const auto& [A, B, C] = triangle;
            const Vec3<Real> P = dice.vector(2 * size), goal = (A + B + C) / 3 + dice.vector(size / 4);
            const Ray<Real> ray{P, unit(goal - P)};
            const Sides<Real> s = sides(ray.D, seen_from(ray.P, triangle));
            // away: no side under a thousandth of the largest they can be
            const Real least = size * size * length(ray.D) / 1000;
            if (std::min({std::abs(s.a), std::abs(s.b), std::abs(s.c), std::abs(s.a + s.b + s.c)}) < least) continue;
            const Crossing<Real> ours = shoot(ray, triangle, Pluecker{});
            const Crossing<Real> theirs = shoot(ray, triangle, MoellerTrumbore{});
            CHECK(ours.met == theirs.met);
            (ours.met ? hits : misses) += 1;
            // both are a quotient whose parts are off by some 100 epsilon of their size, and at least a thousandth of
            // it
            if (ours.met && theirs.met)
                CHECK_WITHIN(ours.t * length(ray.D) / size, theirs.t * length(ray.D) / size, 100000 * epsilon<Real>);
        }
    }
    CHECK(hits > 500);
    CHECK(misses > 500);
}
