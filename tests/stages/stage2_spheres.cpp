// Stage 2: where a ray meets a sphere, by two rules for the same two roots, and which of several hits comes first.
#include <probe.hpp>
#include <sphere.hpp>

#include "checks.hpp"

using namespace glassbox;
using namespace glassbox::test;

namespace {

/// Runs a check with each rule in turn: what holds for the roots must hold whoever computes them.
template <class Check>
void with_both_rules(const Check& check) {
    SUBCASE("textbook") { check(Textbook{}); }
    SUBCASE("stable") { check(Stable{}); }
}

template <class Real, class Rule>
Crossing<Real> shoot(const Ray<Real>& ray, const Sphere<Real>& sphere, const Rule& rule) {
    Silent silent;
    return intersect(ray, sphere, rule, silent);
}

template <class Real, class Rule>
Roots<Real> roots_of(const Ray<Real>& ray, const Sphere<Real>& sphere, const Rule& rule) {
    Silent silent;
    return rule(ray, sphere, silent);
}

template <class Real>
const Sphere<Real> five{{0, 0, 0}, 5};  // r = 5 about the origin

}  // namespace

TEST_CASE_TEMPLATE("a line 3 beside the middle of a sphere of radius 5 runs 8 inside it", Real, EVERY_SCALAR) {
    // Pythagoras: half the chord is 4, as 3^2 + 4^2 = 5^2. From x = -10 it enters at x = -4 and leaves at x = 4.
    with_both_rules([](const auto& rule) {
        const Ray<Real> ray{{-10, 3, 0}, {1, 0, 0}};
        const Roots<Real> roots = roots_of(ray, five<Real>, rule);
        CHECK(roots.real);
        CHECK_EXACT(roots.t0, Real(6));
        CHECK_EXACT(roots.t1, Real(14));
        const Crossing<Real> crossing = shoot(ray, five<Real>, rule);
        CHECK(crossing.met);
        CHECK_EXACT(crossing.t, Real(6));
    });
}

TEST_CASE_TEMPLATE("the roots are exact wherever the answer is whole, along a slanting ray, too", Real, EVERY_SCALAR) {
    // D = (1,2,2) and w = (2,1,-2) have length 3 and stand at right angles. With p^2 + q^2 = h^2, a sphere of radius 3h
    // whose centre lies p w off the line has a chord of half length 3q, that is q in units of |D|. The ray starts s
    // before the chord's middle: t = s - q and t = s + q. Every number on the way is whole and below 2^24.
    struct Triple {
        int p, q, h;
    };
    with_both_rules([](const auto& rule) {
        for (const Triple& triple : {Triple{3, 4, 5}, Triple{12, 5, 13}, Triple{8, 15, 17}, Triple{20, 21, 29}}) {
            for (const int s : {30, 50, 100}) {
                CAPTURE(triple.h);
                CAPTURE(s);
                const Vec3<Real> D{1, 2, 2}, w{2, 1, -2}, c{7, -5, 3};
                const Vec3<Real> P = c + static_cast<Real>(triple.p) * w - static_cast<Real>(s) * D;
                const Roots<Real> roots = roots_of({P, D}, Sphere<Real>{c, static_cast<Real>(3 * triple.h)}, rule);
                CHECK(roots.real);
                CHECK_EXACT(roots.t0, static_cast<Real>(s - triple.q));
                CHECK_EXACT(roots.t1, static_cast<Real>(s + triple.q));
            }
        }
    });
}

TEST_CASE_TEMPLATE("D may have any length: t is measured in it", Real, EVERY_SCALAR) {
    with_both_rules([](const auto& rule) {
        // thrice as long, a third of the t: 6/3 and 14/3
        const Roots<Real> roots = roots_of({{-10, 3, 0}, {3, 0, 0}}, five<Real>, rule);
        CHECK_EXACT(roots.t0, Real(2));
        CHECK_ULPS(roots.t1, Real(14) / 3, 1);
        for (const Real size : sizes<Real>) {  // powers of two: not a bit changes
            CHECK_EXACT(shoot({{-10, 3, 0}, {size, 0, 0}}, five<Real>, rule).t, 6 / size);
        }
    });
}

TEST_CASE_TEMPLATE("a scene of any size: everything larger, t larger, not a bit else", Real, EVERY_SCALAR) {
    with_both_rules([](const auto& rule) {
        Dice dice;
        for (const Real size : sizes<Real>) {
            CAPTURE(size);
            for (int n = 0; n < 200; ++n) {
                const Ray<Real> ray{dice.vector(Real(4)), dice.vector(Real(1))};
                const Sphere<Real> sphere{dice.vector(Real(2)), dice.between(Real(0.5), Real(3))};
                const Crossing<Real> here = shoot(ray, sphere, rule);
                const Crossing<Real> there =
                    shoot({size * ray.P, ray.D}, Sphere<Real>{size * sphere.c, size * sphere.r}, rule);
                CHECK(there.met == here.met);
                CHECK_EXACT(there.t, size * here.t);
            }
        }
    });
}

TEST_CASE_TEMPLATE("moving ray and sphere together changes nothing", Real, EVERY_SCALAR) {
    // Whole numbers move by whole numbers without rounding, and only P - c is ever used.
    with_both_rules([](const auto& rule) {
        Dice dice;
        for (int n = 0; n < 200; ++n) {
            const Vec3<Real> P = dice.whole_vector<Real>(100), D = dice.vector(Real(1)),
                             c = dice.whole_vector<Real>(50);
            const Vec3<Real> move = dice.whole_vector<Real>(1000000);
            const Crossing<Real> here = shoot({P, D}, Sphere<Real>{c, 60}, rule);
            const Crossing<Real> there = shoot({P + move, D}, Sphere<Real>{c + move, 60}, rule);
            CHECK(there.met == here.met);
            CHECK_EXACT(there.t, here.t);
        }
    });
}

TEST_CASE_TEMPLATE("a tangent ray touches the sphere once, and that is a hit", Real, EVERY_SCALAR) {
    with_both_rules([](const auto& rule) {
        for (const Real size : sizes<Real>) {
            CAPTURE(size);
            const Sphere<Real> sphere{{0, 0, 0}, 5 * size};
            // 5 beside the middle of radius 5: it touches at x = 0, 10 from the start
            const Ray<Real> tangent{{-10 * size, 5 * size, 0}, {1, 0, 0}};
            CHECK(shoot(tangent, sphere, rule).met);
            CHECK_EXACT(shoot(tangent, sphere, rule).t, 10 * size);
            CHECK_EXACT(roots_of(tangent, sphere, rule).t1, 10 * size);
            // a little further out, none; a little further in, a hit
            CHECK_FALSE(shoot({{-10 * size, Real(5.25) * size, 0}, {1, 0, 0}}, sphere, rule).met);
            CHECK(shoot({{-10 * size, Real(4.75) * size, 0}, {1, 0, 0}}, sphere, rule).met);
        }
    });
}

TEST_CASE_TEMPLATE("from inside, the ray meets the far wall", Real, EVERY_SCALAR) {
    with_both_rules([](const auto& rule) {
        CHECK(shoot({{0, 0, 0}, {1, 0, 0}}, five<Real>, rule).met);
        CHECK_EXACT(shoot({{0, 0, 0}, {1, 0, 0}}, five<Real>, rule).t, Real(5));
        CHECK_EXACT(shoot({{2, 0, 0}, {1, 0, 0}}, five<Real>, rule).t, Real(3));
        CHECK_EXACT(shoot({{2, 0, 0}, {-1, 0, 0}}, five<Real>, rule).t, Real(7));
        // from (0, 3, 0), half the chord of Pythagoras' 4, both ways
        CHECK_EXACT(shoot({{0, 3, 0}, {1, 0, 0}}, five<Real>, rule).t, Real(4));
        CHECK_EXACT(shoot({{0, 3, 0}, {-1, 0, 0}}, five<Real>, rule).t, Real(4));
        // the nearer root lies behind; it is still told, as the smaller of the two
        CHECK_EXACT(roots_of({{2, 0, 0}, {1, 0, 0}}, five<Real>, rule).t0, Real(-7));
    });
}

TEST_CASE_TEMPLATE("a sphere behind the start is not met", Real, EVERY_SCALAR) {
    with_both_rules([](const auto& rule) {
        const Ray<Real> away{{10, 3, 0}, {1, 0, 0}};
        CHECK_FALSE(shoot(away, five<Real>, rule).met);
        // the line through the ray does cross it: at x = 4 and x = -4
        CHECK(roots_of(away, five<Real>, rule).real);
        CHECK_EXACT(roots_of(away, five<Real>, rule).t0, Real(-14));
        CHECK_EXACT(roots_of(away, five<Real>, rule).t1, Real(-6));
    });
}

TEST_CASE_TEMPLATE("a ray that starts on the sphere does not meet it there: t = 0 is no hit", Real, EVERY_SCALAR) {
    with_both_rules([](const auto& rule) {
        // inwards, it meets the far wall, a diameter away
        CHECK(shoot({{-5, 0, 0}, {1, 0, 0}}, five<Real>, rule).met);
        CHECK_EXACT(shoot({{-5, 0, 0}, {1, 0, 0}}, five<Real>, rule).t, Real(10));
        // from (-4, 3, 0) along x: out at (4, 3, 0)
        CHECK_EXACT(shoot({{-4, 3, 0}, {1, 0, 0}}, five<Real>, rule).t, Real(8));
        // outwards, or along its surface, nothing
        CHECK_FALSE(shoot({{5, 0, 0}, {1, 0, 0}}, five<Real>, rule).met);
        CHECK_FALSE(shoot({{4, 3, 0}, {1, 0, 0}}, five<Real>, rule).met);
        CHECK_FALSE(shoot({{0, 5, 0}, {1, 0, 0}}, five<Real>, rule).met);
    });
}

TEST_CASE_TEMPLATE("a ray that passes by meets nothing", Real, EVERY_SCALAR) {
    with_both_rules([](const auto& rule) {
        CHECK_FALSE(shoot({{-10, 6, 0}, {1, 0, 0}}, five<Real>, rule).met);
        CHECK_FALSE(roots_of({{-10, 6, 0}, {1, 0, 0}}, five<Real>, rule).real);
        CHECK_FALSE(shoot({{-10, 4, 4}, {1, 0, 0}}, five<Real>, rule).met);  // sqrt 32 > 5 beside the middle
    });
}

TEST_CASE_TEMPLATE("the roots come in order, and both lie on the sphere", Real, EVERY_SCALAR) {
    with_both_rules([](const auto& rule) {
        Dice dice;
        int crossed = 0;
        for (const Real size : sizes<Real>) {
            for (int n = 0; n < 300; ++n) {
                const Ray<Real> ray{dice.vector(4 * size), dice.vector(Real(1))};
                const Sphere<Real> sphere{dice.vector(size), dice.between(size, 3 * size)};
                const Roots<Real> roots = roots_of(ray, sphere, rule);
                if (!roots.real) continue;
                ++crossed;
                CAPTURE(size);
                CHECK(roots.t0 <= roots.t1);
                // The start is at most 5 sqrt 3 sizes off, so v.v < 75 sizes squared; it passes through a dozen
                // operations, each off by half an epsilon. Near a tangent t itself is worse, but not the distance
                // squared.
                for (const Real t : {roots.t0, roots.t1}) {
                    const Vec3<Real> v = at(ray, t) - sphere.c;
                    CHECK_WITHIN(dot(v, v) / (size * size), sphere.r * sphere.r / (size * size), 1000 * epsilon<Real>);
                }
            }
        }
        CHECK(crossed > 300);
    });
}

TEST_CASE_TEMPLATE("far away the textbook loses a small sphere, the stable rule does not", Real, EVERY_SCALAR) {
    // c = v.v - r^2 is right only to half an ulp of v.v, up to epsilon/2 of the distance squared: once the distance is
    // r / sqrt(epsilon), r^2 drowns. For float and r = 0.1 that is 290; at 435, as here, rays aimed well inside are
    // lost.
    const Real r = Real(0.1), distance = Real(1.5) * r / std::sqrt(epsilon<Real>);
    CAPTURE(distance);
    Dice dice;
    int lost_by_textbook = 0, lost_by_stable = 0;
    for (int n = 0; n < 1000; ++n) {
        const Sphere<Real> sphere{distance * unit(dice.vector(Real(1))), r};
        const Vec3<Real> aim = sphere.c + dice.vector(r / 2);  // at most sqrt 3 / 2 = 0.87 r off the middle
        const Ray<Real> ray{{0, 0, 0}, unit(aim)};
        lost_by_textbook += !shoot(ray, sphere, Textbook{}).met;
        lost_by_stable += !shoot(ray, sphere, Stable{}).met;
    }
    CHECK(lost_by_textbook > 0);
    CHECK(lost_by_stable == 0);
}

TEST_CASE("in float, a sphere of radius 0.1, 400 away: the textbook loses it, the stable rule finds it") {
    Dice dice;
    int lost_by_textbook = 0, lost_by_stable = 0;
    double worst = 0;
    for (int n = 0; n < 1000; ++n) {
        const Sphere<float> sphere{400 * unit(dice.vector(1.0f)), 0.1f};
        const Ray<float> ray{{0, 0, 0}, unit(sphere.c + dice.vector(0.05f))};
        lost_by_textbook += !shoot(ray, sphere, Textbook{}).met;
        const Crossing<float> found = shoot(ray, sphere, Stable{});
        lost_by_stable += !found.met;
        // long double, with 40 bits more, is the truth here
        const Crossing<long double> truth =
            shoot(convert<long double>(ray), Sphere<long double>{convert<long double>(sphere.c), sphere.r}, Textbook{});
        worst = std::max(worst, std::abs(static_cast<double>(truth.t) - static_cast<double>(found.t)));
    }
    CHECK(lost_by_textbook > 0);
    CHECK(lost_by_stable == 0);
    CHECK(worst < 0.1);  // within a radius, where the textbook is off by the whole sphere
}

TEST_CASE_TEMPLATE("the normal points outwards and has length 1", Real, EVERY_SCALAR) {
    for (const Real size : sizes<Real>) {
        CAPTURE(size);
        // (2, 3, 6) has length 7
        const Sphere<Real> sphere{size * Vec3<Real>{1, 2, 3}, 7 * size};
        CHECK_EXACT(normal(sphere, size * Vec3<Real>{3, 5, 9}), (Vec3<Real>{Real(2) / 7, Real(3) / 7, Real(6) / 7}));
        CHECK_EXACT(normal(sphere, size * Vec3<Real>{-1, -1, -3}),
                    (Vec3<Real>{Real(-2) / 7, Real(-3) / 7, Real(-6) / 7}));
    }
    // outwards from inside, too: which side is seen is the shading's affair
    CHECK_EXACT(normal(five<Real>, at(Ray<Real>{{2, 0, 0}, {1, 0, 0}}, 3)), (Vec3<Real>{1, 0, 0}));
}

TEST_CASE_TEMPLATE("of two hits the nearer stays, whichever is tested first", Real, EVERY_SCALAR) {
    using Best = std::optional<Hit<Real>>;
    const Crossing<Real> near{true, 3}, far{true, 8};
    const Best forwards = nearest(nearest(Best{}, 0, near), 1, far);
    const Best backwards = nearest(nearest(Best{}, 0, far), 1, near);
    REQUIRE(forwards);
    REQUIRE(backwards);
    CHECK(forwards->surface == 0);
    CHECK_EXACT(forwards->t, Real(3));
    CHECK(backwards->surface == 1);
    CHECK_EXACT(backwards->t, Real(3));
}

TEST_CASE_TEMPLATE("of two hits at the same t the surface listed last stays", Real, EVERY_SCALAR) {
    using Best = std::optional<Hit<Real>>;
    const Crossing<Real> hit{true, 3};
    const Best best = nearest(nearest(Best{}, 4, hit), 5, hit);
    REQUIRE(best);
    CHECK(best->surface == 5);
}

TEST_CASE_TEMPLATE("a miss leaves the best hit as it is, and no hits at all stay none", Real, EVERY_SCALAR) {
    using Best = std::optional<Hit<Real>>;
    const Crossing<Real> miss{}, hit{true, 3};
    CHECK_FALSE(nearest(Best{}, 0, miss));
    const Best best = nearest(nearest(Best{}, 0, hit), 1, miss);
    REQUIRE(best);
    CHECK(best->surface == 0);
    CHECK_EXACT(best->t, Real(3));
}
