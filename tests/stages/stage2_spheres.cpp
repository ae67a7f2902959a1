// Stage 2: where a ray meets a sphere, by two rules for the same two roots, and by the rule of the paper's program for
// one; and which of several hits comes first.
#include <cmath>
#include <intersect_sphere.hpp>
#include <levental_2014.hpp>
#include <probe.hpp>
#include <vector>

#include "checks.hpp"
#include "unsure.hpp"

using namespace glassbox;
using namespace glassbox::test;

namespace {

template <class Real, class Rule>
Crossing<Real> shoot(const Ray<Real>& ray, const Sphere<Real>& sphere, const Rule& rule) {
    CAPTURE_RAY(ray, sphere);
    Silent silent;
    return intersect(ray, sphere, rule, silent);
}

template <class Real, class Rule>
Roots<Real> roots_of(const Ray<Real>& ray, const Sphere<Real>& sphere, const Rule& rule) {
    CAPTURE_RAY(ray, sphere);
    Silent silent;
    return rule(ray, sphere, silent);
}

template <class Real>
const Sphere<Real> five{{0, 0, 0}, 5};  // r = 5 about the origin

/// A rule that returns what it was given, to test `intersect` alone, whoever computes the roots.
template <class Real>
struct Given {
    Roots<Real> roots;

    template <class Probe>
    Roots<Real> operator()(const Ray<Real>&, const Sphere<Real>&, Probe&) const {
        return roots;
    }
};

template <class Real>
Crossing<Real> intersect_given(const Roots<Real>& roots) {
    Silent silent;
    return intersect(Ray<Real>{{9, 9, 9}, {1, 0, 0}}, five<Real>, Given<Real>{roots}, silent);
}

template <class Real>
Crossing<Real> first_of(Real t0, Real t1) {
    return intersect_given<Real>({true, t0, t1});
}

/// A probe that keeps what a sphere's test reports, and counts how often.
template <class Real>
struct SphereProbe {
    int tested = 0, discriminants = 0, roots = 0;
    Real discriminant{}, t0{}, t1{};

    template <class What, class... Values>
    void operator()(What, const Values&...) {}
    void operator()(told::Tested) { ++tested; }
    void operator()(told::Discriminant, const Real& d) { ++discriminants, discriminant = d; }
    void operator()(told::Roots, const Real& a, const Real& b) { ++roots, t0 = a, t1 = b; }
};

// Properties of the roots must hold whoever computes them: each of these runs with Textbook and with Stable.

template <class Real, class Rule>
void half_a_chord_is_four(const Rule& rule) {
    // Pythagoras: half the chord is 4, as 3^2 + 4^2 = 5^2. From x = -10 it enters at x = -4 and leaves at x = 4.
    const Roots<Real> roots = roots_of({{-10, 3, 0}, {1, 0, 0}}, five<Real>, rule);
    CHECK(roots.real);
    CHECK_EXACT(roots.t0, Real(6));
    CHECK_EXACT(roots.t1, Real(14));
}

template <class Real, class Rule>
void a_line_that_passes_by_has_no_roots(const Rule& rule) {
    CHECK_FALSE(roots_of({{-10, 6, 0}, {1, 0, 0}}, five<Real>, rule).real);
    CHECK_FALSE(roots_of({{-10, 4, 4}, {1, 0, 0}}, five<Real>, rule).real);  // sqrt 32 > 5 from the centre
}

template <class Real, class Rule>
void inside_and_behind_the_roots_are_negative(const Rule& rule) {
    // from inside, at x = 2: the wall behind is at x = -5, the one ahead at x = 5
    CHECK_EXACT(roots_of({{2, 0, 0}, {1, 0, 0}}, five<Real>, rule).t0, Real(-7));
    CHECK_EXACT(roots_of({{2, 0, 0}, {1, 0, 0}}, five<Real>, rule).t1, Real(3));
    // beyond the sphere: the line through the ray does cross it, at x = 4 and x = -4
    const Roots<Real> behind = roots_of({{10, 3, 0}, {1, 0, 0}}, five<Real>, rule);
    CHECK(behind.real);
    CHECK_EXACT(behind.t0, Real(-14));
    CHECK_EXACT(behind.t1, Real(-6));
}

template <class Real, class Rule>
void a_tangent_has_one_root_twice(const Rule& rule) {
    for (const Real size : sizes<Real>) {
        CAPTURE(size);
        const Sphere<Real> sphere{{0, 0, 0}, 5 * size};
        // 5 from the centre, radius 5: it touches at x = 0, 10 from the start
        const Roots<Real> tangent = roots_of({{-10 * size, 5 * size, 0}, {1, 0, 0}}, sphere, rule);
        CHECK(tangent.real);
        CHECK_EXACT(tangent.t0, 10 * size);
        CHECK_EXACT(tangent.t1, 10 * size);
        // a little further out, none; a little further in, two
        CHECK_FALSE(roots_of({{-10 * size, Real(5.25) * size, 0}, {1, 0, 0}}, sphere, rule).real);
        CHECK(roots_of({{-10 * size, Real(4.75) * size, 0}, {1, 0, 0}}, sphere, rule).real);
        // and where the ray starts in the very point that it touches, both are 0, not 0/0
        const Roots<Real> here = roots_of({{0, 5 * size, 0}, {1, 0, 0}}, sphere, rule);
        CHECK(here.real);
        CHECK_EXACT(here.t0, Real(0));
        CHECK_EXACT(here.t1, Real(0));
    }
}

template <class Real, class Rule>
void d_may_have_any_length(const Rule& rule) {
    // thrice as long, a third of the t: 6/3 and 14/3
    const Roots<Real> roots = roots_of({{-10, 3, 0}, {3, 0, 0}}, five<Real>, rule);
    CHECK_EXACT(roots.t0, Real(2));
    CHECK_ULPS(roots.t1, Real(14) / 3, 1);
    for (const Real size : sizes<Real>)  // powers of two: not a bit changes
        CHECK_EXACT(roots_of({{-10, 3, 0}, {size, 0, 0}}, five<Real>, rule).t0, 6 / size);
}

template <class Real, class Rule>
void whole_answers_are_exact(const Rule& rule) {
    // D = (1,2,2) and w = (2,1,-2) have length 3 and stand at right angles. With p^2 + q^2 = h^2, a sphere of radius 3h
    // whose centre lies p w off the line has a chord of half length 3q, that is q in units of |D|. The ray starts s
    // before the chord's middle: t = s - q and t = s + q. Every number on the way is whole and below 2^24.
    struct Triple {
        int p, q, h;
    };
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
}

template <class Real, class Rule>
void any_size_not_a_bit_changes(const Rule& rule) {
    Dice dice;
    for (const Real size : sizes<Real>) {
        CAPTURE(size);
        for (int n = 0; n < 200; ++n) {
            const Ray<Real> ray{dice.vector(Real(4)), dice.vector(Real(1))};
            const Sphere<Real> sphere{dice.vector(Real(2)), dice.between(Real(0.5), Real(3))};
            const Roots<Real> here = roots_of(ray, sphere, rule);
            const Roots<Real> there =
                roots_of({size * ray.P, ray.D}, Sphere<Real>{size * sphere.C, size * sphere.r}, rule);
            CHECK(there.real == here.real);
            CHECK_EXACT(there.t0, size * here.t0);
            CHECK_EXACT(there.t1, size * here.t1);
        }
    }
}

template <class Real, class Rule>
void moving_both_changes_nothing(const Rule& rule) {
    // Whole numbers move by whole numbers without rounding, and only P - c is ever used.
    Dice dice;
    for (int n = 0; n < 200; ++n) {
        const Vec3<Real> P = dice.whole_vector<Real>(100), D = dice.vector(Real(1)), c = dice.whole_vector<Real>(50);
        const Vec3<Real> move = dice.whole_vector<Real>(1000000);
        const Roots<Real> here = roots_of({P, D}, Sphere<Real>{c, 60}, rule);
        const Roots<Real> there = roots_of({P + move, D}, Sphere<Real>{c + move, 60}, rule);
        CHECK(there.real == here.real);
        CHECK_EXACT(there.t0, here.t0);
        CHECK_EXACT(there.t1, here.t1);
    }
}

template <class Real, class Rule>
void roots_are_ordered_and_on_the_sphere(const Rule& rule) {
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
            // The start is at most 5 sqrt 3 sizes off, so v.v < 75 sizes squared; it passes through a dozen operations,
            // each off by half an epsilon. Near a tangent t itself is worse, but not the distance squared.
            for (const Real t : {roots.t0, roots.t1}) {
                const Vec3<Real> v = at(ray, t) - sphere.C;
                CHECK_WITHIN(dot(v, v) / (size * size), sphere.r * sphere.r / (size * size), 1000 * epsilon<Real>);
            }
        }
    }
    CHECK(crossed > 300);
}

template <class Real, class Rule>
void the_discriminant_is_told(const Rule& rule) {
    // 3 from the centre, radius 5: r^2 - 3^2 = 16, times D.D = 4; and 6 from it: 25 - 36 = -11, times 4
    SphereProbe<Real> hit, miss;
    const Ray<Real> inner{{-10, 3, 0}, {2, 0, 0}}, outer{{-10, 6, 0}, {2, 0, 0}};
    CAPTURE_RAY(inner, five<Real>);
    rule(inner, five<Real>, hit);
    CHECK(hit.discriminants == 1);
    CHECK_EXACT(hit.discriminant, Real(64));
    CAPTURE_RAY(outer, five<Real>);
    rule(outer, five<Real>, miss);
    CHECK(miss.discriminants == 1);
    CHECK_EXACT(miss.discriminant, Real(-44));
}

template <class Rule>
void doubt_is_handed_on(const Rule& rule) {
    // The line touches a sphere of radius 1 where the ray starts: Δ = 0, known to within 1. So it may have roots or
    // not.
    Silent silent;
    const Roots<Unsure> roots = rule(Ray<Unsure>{{0, 1, 0}, {1, 0, 0}}, Sphere<Unsure>{{0, 0, 0}, 1}, silent);
    CHECK(possibly(roots.real));
    CHECK_FALSE(surely(roots.real));
}

// Properties of `intersect`, with real roots.

template <class Real, class Rule>
void spheres_are_met_where_they_should_be(const Rule& rule) {
    const auto t_of = [&](const Ray<Real>& ray) {
        const Crossing<Real> crossing = shoot(ray, five<Real>, rule);
        CHECK(crossing.met);
        return crossing.t;
    };
    CHECK_EXACT(t_of({{-10, 3, 0}, {1, 0, 0}}), Real(6));   // from outside, by Pythagoras
    CHECK_EXACT(t_of({{-10, 5, 0}, {1, 0, 0}}), Real(10));  // touched
    // from inside: ahead, where D points
    CHECK_EXACT(t_of({{0, 0, 0}, {1, 0, 0}}), Real(5));
    CHECK_EXACT(t_of({{2, 0, 0}, {1, 0, 0}}), Real(3));
    CHECK_EXACT(t_of({{2, 0, 0}, {-1, 0, 0}}), Real(7));
    CHECK_EXACT(t_of({{0, 3, 0}, {1, 0, 0}}), Real(4));
    CHECK_EXACT(t_of({{0, 3, 0}, {-1, 0, 0}}), Real(4));
    // from the sphere itself, inwards: a diameter, and from (-4, 3, 0) along x out at (4, 3, 0)
    CHECK_EXACT(t_of({{-5, 0, 0}, {1, 0, 0}}), Real(10));
    CHECK_EXACT(t_of({{-4, 3, 0}, {1, 0, 0}}), Real(8));
}

template <class Real, class Rule>
void spheres_are_missed_where_they_should_be(const Rule& rule) {
    const auto met = [&](const Ray<Real>& ray) { return shoot(ray, five<Real>, rule).met; };
    CHECK_FALSE(met({{-10, 6, 0}, {1, 0, 0}}));  // passes by
    CHECK_FALSE(met({{10, 3, 0}, {1, 0, 0}}));   // runs away
    // starts on the sphere, and leaves it, or runs along its surface: t = 0 is no hit
    CHECK_FALSE(met({{5, 0, 0}, {1, 0, 0}}));
    CHECK_FALSE(met({{4, 3, 0}, {1, 0, 0}}));
    CHECK_FALSE(met({{0, 5, 0}, {1, 0, 0}}));
}

}  // namespace

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
    // whatever the surfaces' numbers are
    const Best falling = nearest(nearest(Best{}, 7, near), 2, far);
    REQUIRE(falling);
    CHECK(falling->surface == 7);
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
    // at whatever t it is missed: that of what lies behind the start is below 0
    for (const Real t : {Real(-6), Real(1), Real(8)}) {
        const Crossing<Real> missed{false, t};
        CHECK_FALSE(nearest(Best{}, 0, missed));
        const Best still = nearest(nearest(Best{}, 0, hit), 1, missed);
        REQUIRE(still);
        CHECK(still->surface == 0);
    }
}

TEST_CASE_TEMPLATE("quadratic: a = D.D, b = v.D, c = v.v - r^2, v from the centre to the start", Real, EVERY_SCALAR) {
    const auto equation = [](const Ray<Real>& ray, const Sphere<Real>& sphere) {
        CAPTURE_RAY(ray, sphere);
        return quadratic(ray, sphere);
    };
    // v = (-10,3,0): 2*2, -10*2, 100 + 9 - 25
    const Quadratic<Real> outside = equation({{-10, 3, 0}, {2, 0, 0}}, five<Real>);
    CHECK_EXACT(outside.a, Real(4));
    CHECK_EXACT(outside.b, Real(-20));
    CHECK_EXACT(outside.c, Real(84));
    // v = (1,2,3) - (4,-2,3) = (-3,4,0), D = (1,2,2): 1 + 4 + 4, -3 + 8, 9 + 16 - 9
    const Quadratic<Real> anywhere = equation({{1, 2, 3}, {1, 2, 2}}, {{4, -2, 3}, 3});
    CHECK_EXACT(anywhere.a, Real(9));
    CHECK_EXACT(anywhere.b, Real(5));
    CHECK_EXACT(anywhere.c, Real(16));
    // from the centre b = 0 and c = -r^2: c is negative inside
    const Quadratic<Real> inside = equation({{4, -2, 3}, {1, 0, 0}}, {{4, -2, 3}, 3});
    CHECK_EXACT(inside.b, Real(0));
    CHECK_EXACT(inside.c, Real(-9));
}

TEST_CASE_TEMPLATE("discriminant: b^2 - ac, of the sign that says how many roots there are", Real, EVERY_SCALAR) {
    CHECK_EXACT(discriminant(Quadratic<Real>{4, -20, 84}), Real(64));  // 400 - 336: two
    CHECK_EXACT(discriminant(Quadratic<Real>{1, 3, 9}), Real(0));      // (t + 3)^2: one
    CHECK_EXACT(discriminant(Quadratic<Real>{9, 5, 16}), Real(-119));  // 25 - 144: none
    CHECK_EXACT(discriminant(Quadratic<Real>{2, 3, -4}), Real(17));    // 9 + 8
}

TEST_CASE_TEMPLATE("roots: (-b - s)/a and (-b + s)/a, s the root of the discriminant", Real, EVERY_SCALAR) {
    const auto both = [](const Quadratic<Real>& equation, Real s) { return roots(equation, s); };
    // 4t^2 - 40t + 84 = 4(t - 3)(t - 7), s = 8
    CHECK_EXACT(both({4, -20, 84}, 8).first, Real(3));
    CHECK_EXACT(both({4, -20, 84}, 8).second, Real(7));
    // t^2 - 25 = (t + 5)(t - 5), s = 5
    CHECK_EXACT(both({1, 0, -25}, 5).first, Real(-5));
    CHECK_EXACT(both({1, 0, -25}, 5).second, Real(5));
    // 2t^2 + 12t + 10 = 2(t + 5)(t + 1), s = 4
    CHECK_EXACT(both({2, 6, 10}, 4).first, Real(-5));
    CHECK_EXACT(both({2, 6, 10}, 4).second, Real(-1));
    // t^2 + 6t + 9 = (t + 3)^2, s = 0
    CHECK_EXACT(both({1, 3, 9}, 0).first, Real(-3));
    CHECK_EXACT(both({1, 3, 9}, 0).second, Real(-3));
}

TEST_CASE_TEMPLATE("first_ahead: the smaller t where it is above 0, else the larger", Real, EVERY_SCALAR) {
    CHECK_EXACT(first_ahead(Real(6), Real(14)), Real(6));     // before the sphere
    CHECK_EXACT(first_ahead(Real(-7), Real(3)), Real(3));     // inside
    CHECK_EXACT(first_ahead(Real(-3), Real(7)), Real(7));     // however near the one behind is
    CHECK_EXACT(first_ahead(Real(0), Real(10)), Real(10));    // on the sphere, inwards: 0 is not ahead
    CHECK_EXACT(first_ahead(Real(-14), Real(-6)), Real(-6));  // behind: who asks sees that it is not above 0
    const Real least = std::numeric_limits<Real>::denorm_min();
    CHECK_EXACT(first_ahead(least, Real(1)), least);
}

TEST_CASE("first_ahead: where it is undecided whether the smaller t lies ahead, it is that one") {
    CHECK_EXACT(first_ahead(Unsure(0.5), Unsure(14)).value, 0.5);  // 0.5, known to within 1
    CHECK_EXACT(first_ahead(Unsure(-3), Unsure(14)).value, 14.0);
}

TEST_CASE_TEMPLATE("Textbook: a line 3 beside the middle of a sphere of radius 5 runs 8 inside it", Real,
                   EVERY_SCALAR) {
    half_a_chord_is_four<Real>(Textbook{});
}

TEST_CASE_TEMPLATE("Textbook: a line that passes by has no roots", Real, EVERY_SCALAR) {
    a_line_that_passes_by_has_no_roots<Real>(Textbook{});
}

TEST_CASE_TEMPLATE("Textbook: from inside one root is negative, from beyond both are", Real, EVERY_SCALAR) {
    inside_and_behind_the_roots_are_negative<Real>(Textbook{});
}

TEST_CASE_TEMPLATE("Textbook: a tangent has one root twice", Real, EVERY_SCALAR) {
    a_tangent_has_one_root_twice<Real>(Textbook{});
}

TEST_CASE_TEMPLATE("Textbook: D may have any length, t is measured in it", Real, EVERY_SCALAR) {
    d_may_have_any_length<Real>(Textbook{});
}

TEST_CASE_TEMPLATE("Textbook: the roots are exact wherever the answer is whole", Real, EVERY_SCALAR) {
    whole_answers_are_exact<Real>(Textbook{});
}

TEST_CASE_TEMPLATE("Textbook: a scene of any size: everything larger, t larger, not a bit else", Real, EVERY_SCALAR) {
    any_size_not_a_bit_changes<Real>(Textbook{});
}

TEST_CASE_TEMPLATE("Textbook: moving ray and sphere together changes nothing", Real, EVERY_SCALAR) {
    moving_both_changes_nothing<Real>(Textbook{});
}

TEST_CASE_TEMPLATE("Textbook: the roots come in order, and both lie on the sphere", Real, EVERY_SCALAR) {
    roots_are_ordered_and_on_the_sphere<Real>(Textbook{});
}

TEST_CASE_TEMPLATE("Textbook: the probe is told the discriminant", Real, EVERY_SCALAR) {
    the_discriminant_is_told<Real>(Textbook{});
}

TEST_CASE("Textbook: where the sign of the discriminant is undecided, so is whether there are roots") {
    doubt_is_handed_on(Textbook{});
}

TEST_CASE_TEMPLATE("intersect: ahead of the sphere the smaller root counts", Real, EVERY_SCALAR) {
    CHECK(first_of(Real(6), Real(14)).met);
    CHECK_EXACT(first_of(Real(6), Real(14)).t, Real(6));
}

TEST_CASE_TEMPLATE("intersect: from inside the larger root counts", Real, EVERY_SCALAR) {
    CHECK(first_of(Real(-7), Real(3)).met);
    CHECK_EXACT(first_of(Real(-7), Real(3)).t, Real(3));
    CHECK_EXACT(first_of(Real(-3), Real(7)).t, Real(7));  // however near the one behind is
}

TEST_CASE_TEMPLATE("intersect: what lies behind is not met", Real, EVERY_SCALAR) {
    CHECK_FALSE(first_of(Real(-14), Real(-6)).met);
}

TEST_CASE_TEMPLATE("intersect: t = 0 is no hit", Real, EVERY_SCALAR) {
    CHECK(first_of(Real(0), Real(10)).met);  // starts on the sphere, inwards: the far wall
    CHECK_EXACT(first_of(Real(0), Real(10)).t, Real(10));
    CHECK_FALSE(first_of(Real(-10), Real(0)).met);  // outwards
    CHECK_FALSE(first_of(Real(0), Real(0)).met);    // along the surface
    const Real least = std::numeric_limits<Real>::denorm_min();
    CHECK(first_of(least, Real(1)).met);  // but any t above 0 is one
    CHECK_EXACT(first_of(least, Real(1)).t, least);
}

TEST_CASE_TEMPLATE("intersect: no roots, no hit", Real, EVERY_SCALAR) {
    CHECK_FALSE(intersect_given<Real>({false, 6, 14}).met);
}

TEST_CASE("intersect: where it is undecided whether there are roots, or a root lies ahead, so is whether it is met") {
    const UnsureTruth undecided = UnsureTruth::undecided();
    const Crossing<Unsure> grazing = intersect_given<Unsure>({undecided, 6, 14});
    CHECK(possibly(grazing.met));
    CHECK_FALSE(surely(grazing.met));
    CHECK_EXACT(grazing.t.value, 6.0);
    const Crossing<Unsure> close = intersect_given<Unsure>({true, 0.5, 14});  // 0.5, known to within 1
    CHECK(possibly(close.met));
    CHECK_FALSE(surely(close.met));
    CHECK_EXACT(close.t.value, 0.5);
    CHECK_FALSE(surely(intersect_given<Unsure>({true, -14, 0.5}).met));
    CHECK_FALSE(surely(intersect_given<Unsure>({undecided, -7, 3}).met));
}

TEST_CASE_TEMPLATE("intersect: a sphere about the origin is met where it should be", Real, EVERY_SCALAR) {
    spheres_are_met_where_they_should_be<Real>(Textbook{});
}

TEST_CASE_TEMPLATE("intersect: a sphere about the origin is missed where it should be", Real, EVERY_SCALAR) {
    spheres_are_missed_where_they_should_be<Real>(Textbook{});
}

TEST_CASE_TEMPLATE("intersect: the probe is told the roots, once a sphere", Real, EVERY_SCALAR) {
    SphereProbe<Real> hit, miss;
    intersect(Ray<Real>{{2, 0, 0}, {1, 0, 0}}, five<Real>, Given<Real>{{true, -7, 3}}, hit);
    CHECK(hit.tested == 1);
    CHECK(hit.roots == 1);
    CHECK_EXACT(hit.t0, Real(-7));
    CHECK_EXACT(hit.t1, Real(3));
    intersect(Ray<Real>{{2, 0, 0}, {1, 0, 0}}, five<Real>, Given<Real>{{false, 0, 0}}, miss);
    CHECK(miss.tested == 1);
    CHECK(miss.roots == 0);  // there are none
}

TEST_CASE_TEMPLATE("intersect: by the rule of the paper's program a touch is a miss", Real, EVERY_SCALAR) {
    const Levental2014 rule;
    for (const Real size : sizes<Real>) {
        CAPTURE(size);
        const Sphere<Real> sphere{{0, 0, 0}, 5 * size};
        const auto beside = [&](Real y, Real z) {
            return shoot<Real>({{-10 * size, y * size, z * size}, {1, 0, 0}}, sphere, rule);
        };
        CHECK_FALSE(beside(5, 0).met);  // 5 from the centre, radius 5; and again, as 3^2 + 4^2 = 5^2
        CHECK_FALSE(beside(3, 4).met);
        CHECK_FALSE(beside(6, 0).met);
        CHECK(beside(Real(4.75), 0).met);
        CHECK(beside(3, 0).met);  // half the chord is 4: in at x = -4
        CHECK_EXACT(beside(3, 0).t, 6 * size);
    }
}

TEST_CASE_TEMPLATE("intersect: by the rule of the paper's program a sphere vanishes from inside", Real, EVERY_SCALAR) {
    const Levental2014 rule;
    CHECK_FALSE(shoot<Real>({{0, 0, 0}, {1, 0, 0}}, five<Real>, rule).met);
    CHECK_FALSE(shoot<Real>({{2, 0, 0}, {-1, 0, 0}}, five<Real>, rule).met);
    CHECK_FALSE(shoot<Real>({{-5, 0, 0}, {1, 0, 0}}, five<Real>, rule).met);  // on the sphere, and in: t = 0 and 10
    CHECK_FALSE(shoot<Real>({{10, 3, 0}, {1, 0, 0}}, five<Real>, rule).met);  // and what lies behind is not met
    const Roots<Real> inside = roots_of<Real>({{2, 0, 0}, {1, 0, 0}}, five<Real>, rule);
    CHECK(inside.real);
    CHECK_EXACT(inside.t0, Real(-7));  // at x = -5; it knows no other
    CHECK_EXACT(inside.t1, Real(-7));
}

TEST_CASE_TEMPLATE("intersect: the rule of the paper's program in whole numbers, at every scale", Real, EVERY_SCALAR) {
    // With a = D.D, b = v.D and c = v.v - r^2 it meets the sphere iff b^2 - ac > 0 and its nearer root is above 0:
    // -b > sqrt(b^2 - ac) iff b < 0 and ac > 0. In whole numbers these three are exact: |b| <= 3 * 6 = 18 and
    // |ac| <= 3 * 3 * 6^2 = 324.
    std::vector<Real> scales(sizes<Real>.begin(), sizes<Real>.end());
    if (std::numeric_limits<Real>::max_exponent > 1000)  // 1e-100 and 1e100
        for (const int power : {-332, 332}) scales.push_back(std::ldexp(Real(1), power));
    Dice dice;
    int touched = 0, met = 0, inside = 0;
    for (int n = 0; n < 600; ++n) {
        const Vec3<Real> P = dice.whole_vector<Real>(3), D = dice.whole_vector<Real>(1), C = dice.whole_vector<Real>(3);
        const auto r = static_cast<Real>(dice.whole(1, 3));
        const auto product = [](const Vec3<Real>& p, const Vec3<Real>& q) {
            return static_cast<int>(p.x * q.x + p.y * q.y + p.z * q.z);
        };
        const Vec3<Real> v{P.x - C.x, P.y - C.y, P.z - C.z};
        const int a = product(D, D), b = product(v, D), c = product(v, v) - static_cast<int>(r * r);
        if (a == 0) continue;
        const bool expected = b * b - a * c > 0 && b < 0 && c > 0;
        met += expected, touched += b * b == a * c && b < 0, inside += c < 0;
        for (const Real size : scales) {
            CAPTURE(size);
            const Ray<Real> ray{{size * P.x, size * P.y, size * P.z}, D};
            CHECK(shoot<Real>(ray, {{size * C.x, size * C.y, size * C.z}, size * r}, Levental2014{}).met == expected);
        }
    }
    CHECK(met > 20);
    CHECK(touched > 5);
    CHECK(inside > 20);
}

TEST_CASE_TEMPLATE("intersect: the rule of the paper's program asks for Δ > 0, and not just for Δ >= 0", Real,
                   EVERY_SCALAR) {
    // Rays aimed at a sphere's outline, off by some roundings: Δ comes out as 0 now and then, mostly just not.
    Dice dice;
    int zero = 0, above = 0;
    for (const Real size : sizes<Real>)
        for (int n = 0; n < 300; ++n) {
            const Vec3<Real> P = dice.vector(20 * size), to_center = dice.vector(10 * size);
            const Vec3<Real> aside = unit(cross(to_center, dice.vector(Real(1))));
            const Real r = dice.between(size, 3 * size), off = epsilon<Real> * static_cast<Real>(dice.whole(-4, 4));
            // A line along to_center, r from the centre.
            const Ray<Real> ray{P + r * (1 + off) * aside, to_center};
            const Sphere<Real> sphere{P + to_center, r};
            CAPTURE_RAY(ray, sphere);
            SphereProbe<Real> heard;
            const Roots<Real> roots = Levental2014{}(ray, sphere, heard);
            CHECK(heard.discriminants == 1);
            CHECK(roots.real == (heard.discriminant > 0));
            zero += heard.discriminant == 0, above += heard.discriminant > 0;
        }
    CHECK(zero > 0);
    CHECK(above > 100);
}

TEST_CASE("intersect: the rule of the paper's program hands doubt on") {
    // Δ = 0, known to within 1, so it may be met at t = 10.
    Silent silent;
    const Crossing<Unsure> touched =
        intersect(Ray<Unsure>{{-10, 1, 0}, {1, 0, 0}}, Sphere<Unsure>{{0, 0, 0}, 1}, Levental2014{}, silent);
    CHECK(possibly(touched.met));
    CHECK_FALSE(surely(touched.met));
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

TEST_CASE_TEMPLATE("chord: its middle is the line's point nearest to the centre", Real, EVERY_SCALAR) {
    const auto chord_of = [](const Ray<Real>& ray, const Sphere<Real>& sphere) {
        CAPTURE_RAY(ray, sphere);
        return chord(ray, sphere);
    };
    // v = (-10,3,0), D = (2,0,0): a = 4, m = 20, so the middle is at t = 5, 3 beside the centre
    const Chord<Real> above = chord_of({{-10, 3, 0}, {2, 0, 0}}, five<Real>);
    CHECK_EXACT(above.a, Real(4));
    CHECK_EXACT(above.m, Real(20));
    CHECK_EXACT(above.v, (Vec3<Real>{-10, 3, 0}));
    CHECK_EXACT(above.l, (Vec3<Real>{0, 3, 0}));
    // v = (-4,2,3), D = (1,1,0): a = 2, m = 4 - 2 = 2, t = 1, l = (-3,3,3)
    const Chord<Real> slanting = chord_of({{-3, 4, 6}, {1, 1, 0}}, {{1, 2, 3}, 9});
    CHECK_EXACT(slanting.a, Real(2));
    CHECK_EXACT(slanting.m, Real(2));
    CHECK_EXACT(slanting.v, (Vec3<Real>{-4, 2, 3}));
    CHECK_EXACT(slanting.l, (Vec3<Real>{-3, 3, 3}));
    // behind the start m is negative: the middle is at t = -20/4
    CHECK_EXACT(chord_of({{10, 3, 0}, {2, 0, 0}}, five<Real>).m, Real(-20));
    CHECK_EXACT(chord_of({{10, 3, 0}, {2, 0, 0}}, five<Real>).l, (Vec3<Real>{0, 3, 0}));
}

TEST_CASE_TEMPLATE("discriminant of a chord: a (r^2 - l^2), the same number as b^2 - ac", Real, EVERY_SCALAR) {
    CHECK_EXACT(discriminant(Chord<Real>{4, 20, {-10, 3, 0}, {0, 3, 0}}, Real(5)), Real(64));   // 4 (25 - 9)
    CHECK_EXACT(discriminant(Chord<Real>{4, 20, {-10, 6, 0}, {0, 6, 0}}, Real(5)), Real(-44));  // 4 (25 - 36)
    CHECK_EXACT(discriminant(Chord<Real>{9, 0, {0, 3, 4}, {0, 3, 4}}, Real(5)), Real(0));       // 3^2 + 4^2 = 5^2
}

TEST_CASE_TEMPLATE("Stable: a line 3 beside the middle of a sphere of radius 5 runs 8 inside it", Real, EVERY_SCALAR) {
    half_a_chord_is_four<Real>(Stable{});
}

TEST_CASE_TEMPLATE("Stable: a line that passes by has no roots", Real, EVERY_SCALAR) {
    a_line_that_passes_by_has_no_roots<Real>(Stable{});
}

TEST_CASE_TEMPLATE("Stable: from inside one root is negative, from beyond both are", Real, EVERY_SCALAR) {
    inside_and_behind_the_roots_are_negative<Real>(Stable{});
}

TEST_CASE_TEMPLATE("Stable: a tangent has one root twice", Real, EVERY_SCALAR) {
    a_tangent_has_one_root_twice<Real>(Stable{});
}

TEST_CASE_TEMPLATE("Stable: D may have any length, t is measured in it", Real, EVERY_SCALAR) {
    d_may_have_any_length<Real>(Stable{});
}

TEST_CASE_TEMPLATE("Stable: the roots are exact wherever the answer is whole", Real, EVERY_SCALAR) {
    whole_answers_are_exact<Real>(Stable{});
}

TEST_CASE_TEMPLATE("Stable: a scene of any size: everything larger, t larger, not a bit else", Real, EVERY_SCALAR) {
    any_size_not_a_bit_changes<Real>(Stable{});
}

TEST_CASE_TEMPLATE("Stable: moving ray and sphere together changes nothing", Real, EVERY_SCALAR) {
    moving_both_changes_nothing<Real>(Stable{});
}

TEST_CASE_TEMPLATE("Stable: the roots come in order, and both lie on the sphere", Real, EVERY_SCALAR) {
    roots_are_ordered_and_on_the_sphere<Real>(Stable{});
}

TEST_CASE_TEMPLATE("Stable: the probe is told the discriminant", Real, EVERY_SCALAR) {
    the_discriminant_is_told<Real>(Stable{});
}

TEST_CASE("Stable: where the sign of the discriminant is undecided, so is whether there are roots") {
    doubt_is_handed_on(Stable{});
}

TEST_CASE_TEMPLATE("Stable: a sphere about the origin is met where it should be", Real, EVERY_SCALAR) {
    spheres_are_met_where_they_should_be<Real>(Stable{});
}

TEST_CASE_TEMPLATE("Stable: a sphere about the origin is missed where it should be", Real, EVERY_SCALAR) {
    spheres_are_missed_where_they_should_be<Real>(Stable{});
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
        const Vec3<Real> aim = sphere.C + dice.vector(r / 2);  // at most sqrt 3 / 2 = 0.87 r off the middle
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
        const Ray<float> ray{{0, 0, 0}, unit(sphere.C + dice.vector(0.05f))};
        lost_by_textbook += !shoot(ray, sphere, Textbook{}).met;
        const Crossing<float> found = shoot(ray, sphere, Stable{});
        lost_by_stable += !found.met;
        // long double, with 40 bits more, is the truth here
        const Crossing<long double> truth =
            shoot(convert<long double>(ray), Sphere<long double>{convert<long double>(sphere.C), sphere.r}, Textbook{});
        worst = std::max(worst, std::abs(static_cast<double>(truth.t) - static_cast<double>(found.t)));
    }
    CHECK(lost_by_textbook > 0);
    CHECK(lost_by_stable == 0);
    CHECK(worst < 0.1);  // within a radius, where the textbook is off by the whole sphere
}
