// Stage 6: bounds on rounding. They must hold, and they must not be so large that they say nothing. The truth is
// computed in integers of 128 bits, which round nothing: all inputs here are integers.
#include <bounded.hpp>
#include <filter.hpp>
#include <magnitude.hpp>
#include <sides.hpp>

#include "checks.hpp"

namespace glassbox::test {

/// What a comparison says, as a word to be shown.
struct Said {
    std::string word;

    friend bool operator==(const Said& a, const Said& b) { return a.word == b.word; }
};

Said said(Kleene truth) { return {surely(truth) ? "yes" : possibly(truth) ? "undecided" : "no"}; }
double ulps(const Said& got, const Said& expected) { return got == expected ? 0 : HUGE_VAL; }
std::string shown(const Said& said) { return said.word; }

void check_at_least(double got, double least, const char* expression, const char* file, int line) {
    if (got >= least) return passed();
    failed({file, line, expression, "at least " + shown(least), shown(got), ulps(got, least)});
}

void check_at_most(double got, double most, const char* expression, const char* file, int line) {
    if (got <= most) return passed();
    failed({file, line, expression, "at most " + shown(most), shown(got), ulps(got, most)});
}

}  // namespace glassbox::test

/// Fails, with expected and got, if a bound is smaller than what it has to cover.
#define CHECK_AT_LEAST(got, least) glassbox::test::check_at_least((got), (least), #got, __FILE__, __LINE__)
/// Fails, with expected and got, if a bound is so large that it says too little.
#define CHECK_AT_MOST(got, most) glassbox::test::check_at_most((got), (most), #got, __FILE__, __LINE__)

using namespace glassbox;
using namespace glassbox::test;

namespace {

__extension__ typedef __int128 Whole;

constexpr double u = 0x1p-53;  // the largest relative error of one operation
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A bound must be the expected one, within a few of its own roundings.
constexpr double nearly = 0x1p-40;

Whole whole(double value) { return static_cast<Whole>(value); }

/// D·(B × A), A, B and D whole numbers.
Whole true_side(const Vec3<double>& D, const Vec3<double>& A, const Vec3<double>& B) {
    const Whole ax = whole(A.x), ay = whole(A.y), az = whole(A.z), bx = whole(B.x), by = whole(B.y), bz = whole(B.z);
    return whole(D.x) * (by * az - bz * ay) + whole(D.y) * (bz * ax - bx * az) + whole(D.z) * (bx * ay - by * ax);
}

/// |computed − truth| of a number that is whole though it was rounded. The difference is small: it fits into a double.
double off(double computed, Whole truth) {
    const Whole difference = whole(computed) - truth;
    return static_cast<double>(difference < 0 ? -difference : difference);
}

/// By how much the three side products of a ray are off, at most.
double sides_off(const Ray<double>& ray, const Triangle<double>& triangle) {
    const auto& [A, B, C] = seen_from(ray.P, triangle);  // whole numbers below 2⁵³: nothing is rounded here
    const Sides<double> s = sides(ray.D, Triangle<double>{A, B, C});
    return std::max(
        {off(s.a, true_side(ray.D, B, C)), off(s.b, true_side(ray.D, C, A)), off(s.c, true_side(ray.D, A, B))});
}

/// The largest of the three side products, all of their terms taken as positive.
double sides_size(const Ray<double>& ray, const Triangle<double>& triangle) {
    const auto size = [](const Vec3<double>& v) { return Vec3<double>{std::abs(v.x), std::abs(v.y), std::abs(v.z)}; };
    const auto sum = [&](const Vec3<double>& A, const Vec3<double>& B) {
        const Vec3<double> D = size(ray.D), P = size(ray.P);
        const Vec3<double> a = size(A) + P, b = size(B) + P;
        return D.x * (b.y * a.z + b.z * a.y) + D.y * (b.z * a.x + b.x * a.z) + D.z * (b.x * a.y + b.y * a.x);
    };
    const auto& [A, B, C] = triangle;
    return std::max({sum(B, C), sum(C, A), sum(A, B)});
}

/// What a filter for just this ray says.
double error_for(const Ray<double>& ray, const Triangle<double>& triangle) {
    return filter::sides_error(triangle, including(RayBounds{}, ray));
}

Vec3<double> whole_vector(Dice& dice, double size) {
    const Vec3<double> v = dice.vector(size);
    return {std::trunc(v.x), std::trunc(v.y), std::trunc(v.z)};
}

}  // namespace

// Bounded +

TEST_CASE("a sum adds up both errors, and its own rounding") {
    // (3 ± 1/4) + (5 ± 1/2) = 8 ± 3/4, and 8 may be off by 8u
    const Bounded sum = Bounded(3, 0.25) + Bounded(5, 0.5);
    CHECK_EXACT(sum.value, 8.0);
    CHECK_WITHIN(sum.error, 0.75 + 8 * u, nearly);
    // and a difference adds them up as well
    const Bounded difference = Bounded(3, 0.25) - Bounded(5, 0.5);
    CHECK_EXACT(difference.value, -2.0);
    CHECK_WITHIN(difference.error, 0.75 + 2 * u, nearly);
}

TEST_CASE("a sum of exact numbers is off by its rounding alone") {
    // 2⁵³ + 1 is no double: the sum is 2⁵³, off by 1, and u 2⁵³ = 1
    const Bounded odd = Bounded(0x1p53) + Bounded(1);
    CHECK_AT_LEAST(odd.error, 1);
    CHECK_AT_MOST(odd.error, 1 + nearly);
    // the same below 0
    const Bounded negative = Bounded(-0x1p53) + Bounded(-1);
    CHECK_AT_LEAST(negative.error, 1);
    CHECK_AT_MOST(negative.error, 1 + nearly);
    // it is rounded in proportion to the result: 2⁴⁰ + 1 − 2⁴⁰ is off by u, not by u 2⁴¹
    const Bounded small = Bounded(0x1p40 + 1) + Bounded(-0x1p40);
    CHECK_EXACT(small.value, 1.0);
    CHECK_AT_MOST(small.error, u * (1 + nearly));
    // The double 0.1 is 0x1.999999999999ap-4, and 0.2 twice that. Their sum, thrice that, is 0x1.33333333333338p-2, the
    // middle between two doubles that are 2⁻⁵⁴ apart.
    for (const double sign : {1.0, -1.0}) CHECK_AT_LEAST((Bounded(sign * 0.1) + Bounded(sign * 0.2)).error, 0x1p-55);
}

TEST_CASE("the error of a sum is itself rounded upwards") {
    // 7 − 7 = 0 is not rounded. The errors are 2⁵³ and 1: the truth may be 2⁵³ + 1 away, which rounds to 2⁵³.
    const Bounded sum = Bounded(7, 0x1p53) + Bounded(-7, 1);
    CHECK_AT_LEAST(sum.error, 0x1p53 + 2);  // the double above 2⁵³ + 1
    CHECK_AT_MOST(sum.error, 0x1p53 * (1 + nearly));
}

// Bounded ·

TEST_CASE("a product's error: each error times the other factor, and both errors' product") {
    // (3 ± 1/4)(5 ± 1/2) is at most 3.25 · 5.5 = 17.875: 2.875 = 3/2 + 5/4 + 1/8 away from 15, which may be off by 15u
    const double most = 2.875 + 15 * u;
    for (const double sign : {1.0, -1.0}) {
        const Bounded product = Bounded(sign * 3, 0.25) * Bounded(5, 0.5);
        CHECK_EXACT(product.value, sign * 15);
        CHECK_WITHIN(product.error, most, nearly);
        CHECK_WITHIN((Bounded(5, 0.5) * Bounded(sign * 3, 0.25)).error, most, nearly);
    }
    // (3 ± 1/4)(1/2 ± 1/8) is at most 3.25 · 0.625 = 2.03125, which is 0.53125 = 3/8 + 1/8 + 1/32 away from 1.5
    CHECK_WITHIN((Bounded(3, 0.25) * Bounded(0.5, 0.125)).error, 0.53125 + 1.5 * u, nearly);
    CHECK_WITHIN((Bounded(0.5, 0.125) * Bounded(3, 0.25)).error, 0.53125 + 1.5 * u, nearly);
}

TEST_CASE("a product's error is itself rounded upwards") {
    // (1 ± 2⁵³)(1 ± 1) is at most (1 + 2⁵³) · 2 = 2⁵⁴ + 2, which is 2⁵⁴ + 1 away from 1
    const Bounded product = Bounded(1, 0x1p53) * Bounded(1, 1);
    CHECK_AT_LEAST(product.error, 0x1p54 + 4);  // the double above 2⁵⁴ + 1
    CHECK_AT_MOST(product.error, 0x1p54 * (1 + nearly));
}

TEST_CASE("a product of exact numbers is off by its rounding alone") {
    // (2³⁰ + 1)² = 2⁶⁰ + 2³¹ + 1: doubles of this size are 2⁸ apart, so it is off by 1; and u 2⁶⁰ = 128
    const Bounded square = Bounded(0x1p30 + 1) * Bounded(0x1p30 + 1);
    CHECK_AT_LEAST(square.error, 1);
    CHECK_WITHIN(square.error, 128.0, 1e-6);
    // a tenth and ten, exact inputs both, give 1, though the double 0.1 is 2⁻⁵⁸ or so above a tenth
    CHECK_WITHIN((Bounded(0.1) * Bounded(10)).error, u, u * nearly);
}

TEST_CASE("a product that underflows is not exactly 0; one with an exact 0 is") {
    // 2⁻⁶⁰⁰ squared is 2⁻¹²⁰⁰, too small for a double: 0, but the truth is not
    const Bounded tiny = Bounded(0x1p-600) * Bounded(0x1p-600);
    CHECK_EXACT(tiny.value, 0.0);
    CHECK_AT_LEAST(tiny.error, 0x1p-1074);
    CHECK_AT_MOST(tiny.error, 0x1p-1000);
    // 0 times anything is 0, however little is known of the other factor
    CHECK_EXACT((Bounded(0) * Bounded(5, 1)).error, 0.0);
    CHECK_EXACT((Bounded(0) * Bounded(0)).error, 0.0);
    CHECK_EXACT((Bounded(5, infinity) * Bounded(0)).error, 0.0);
    CHECK_EXACT((Bounded(5, infinity) * Bounded(0)).value, 0.0);
}

// Bounded <

TEST_CASE("less is sure where the intervals lie apart, undecided where they overlap") {
    CHECK_EXACT(said(Bounded(1, 0.25) < Bounded(2, 0.25)), Said{"yes"});  // at most 1.25, at least 1.75
    CHECK_EXACT(said(Bounded(2, 0.25) < Bounded(1, 0.25)), Said{"no"});
    CHECK_EXACT(said(Bounded(1, 0.5) < Bounded(1.75, 0.5)), Said{"undecided"});  // both may be 1.4
    CHECK_EXACT(said(Bounded(1.75, 0.5) < Bounded(1, 0.5)), Said{"undecided"});
    CHECK_EXACT(said(Bounded(1, 0.5) < Bounded(2, 0.5)), Said{"undecided"});  // both may be 1.5
    CHECK_EXACT(said(Bounded(-1, 0.25) < Bounded(0)), Said{"yes"});           // a sign
    CHECK_EXACT(said(Bounded(1, 0.25) < Bounded(0)), Said{"no"});
    // just apart: at most 1, and 1 + 2⁻³⁰
    CHECK_EXACT(said(Bounded(0, 1) < Bounded(1 + 0x1p-30)), Said{"yes"});
    CHECK_EXACT(said(Bounded(1 + 0x1p-30) < Bounded(0, 1)), Said{"no"});
    // however small the numbers are
    CHECK_EXACT(said(Bounded(0, 0x1p-210) < Bounded(0x1p-200)), Said{"yes"});
    CHECK_EXACT(said(Bounded(0x1p-200) < Bounded(0, 0x1p-210)), Said{"no"});
    CHECK_EXACT(said(Bounded(0, 0x1p-1074) < Bounded(0x1p-1074)), Said{"undecided"});  // both may be 2⁻¹⁰⁷⁴
}

TEST_CASE("either of the two errors can make less undecided") {
    CHECK_EXACT(said(Bounded(0, 0.5) < Bounded(0.25)), Said{"undecided"});
    CHECK_EXACT(said(Bounded(0.25) < Bounded(0, 0.5)), Said{"undecided"});
    CHECK_EXACT(said(Bounded(0.25) < Bounded(0, 0.125)), Said{"no"});
    CHECK_EXACT(said(Bounded(0, 0.125) < Bounded(0.25)), Said{"yes"});
}

TEST_CASE("exact numbers are always decided") {
    CHECK_EXACT(said(Bounded(1) < Bounded(1)), Said{"no"});
    CHECK_EXACT(said(Bounded(1) <= Bounded(1)), Said{"yes"});
    CHECK_EXACT(said(Bounded(2) < Bounded(1)), Said{"no"});
    CHECK_EXACT(said(Bounded(1) < Bounded(1 + 0x1p-52)), Said{"yes"});  // the next double
    CHECK_EXACT(said(Bounded(0) < Bounded(0x1p-1074)), Said{"yes"});
}

TEST_CASE("of numbers lost to overflow nothing is decided") {
    const Bounded overflow = Bounded(0x1p1000) * Bounded(0x1p1000);
    CHECK_EXACT(said(Bounded(1) < overflow), Said{"undecided"});
    CHECK_EXACT(said(overflow < Bounded(1)), Said{"undecided"});
    CHECK_EXACT(said(Bounded(infinity) < Bounded(1)), Said{"undecided"});
    CHECK_EXACT(said(Bounded(1) < Bounded(infinity)), Said{"undecided"});
    CHECK_EXACT(said(Bounded(-infinity) < Bounded(infinity)), Said{"undecided"});
    CHECK_EXACT(said(overflow - overflow < Bounded(1)), Said{"undecided"});  // not a number
    CHECK_EXACT(said(Bounded(0, infinity) < Bounded(1)), Said{"undecided"});
}

TEST_CASE("running bounds hold for the side products of any ray, and decide most of their signs") {
    Dice dice;
    int undecided = 0;
    for (int n = 0; n < 500; ++n) {
        const Vec3<double> A = whole_vector(dice, 0x1p40), B = whole_vector(dice, 0x1p40),
                           D = whole_vector(dice, 0x1p40);
        const Bounded s = side(convert<Bounded>(D), convert<Bounded>(A), convert<Bounded>(B));
        const Whole truth = true_side(D, A, B);
        CHECK_AT_LEAST(s.error, off(s.value, truth));
        const Kleene negative = s < Bounded(0);
        if (surely(negative) || !possibly(negative)) CHECK(surely(negative) == (truth < 0));
        undecided += !surely(negative) && possibly(negative);
    }
    // s is a sum of six terms up to 2¹²⁰, and its bound some 2⁻⁵¹ of that: hardly any s is nearer to 0
    CHECK_AT_MOST(undecided, 0);
}

// Magnitude

TEST_CASE("a sum of magnitudes adds sizes") {
    CHECK_EXACT((Magnitude(3.0) + Magnitude(5.0)).size, 8.0);
    CHECK_EXACT((Magnitude(3.0) + Magnitude(-5.0)).size, 8.0);
}

TEST_CASE("a difference of magnitudes adds sizes, too") {
    CHECK_EXACT((Magnitude(3.0) - Magnitude(5.0)).size, 8.0);
    CHECK_EXACT((Magnitude(-3.0) - Magnitude(3.0)).size, 6.0);
}

TEST_CASE("a product of magnitudes multiplies sizes") { CHECK_EXACT((Magnitude(-3.0) * Magnitude(5.0)).size, 15.0); }

TEST_CASE("a formula of magnitudes adds up its terms' sizes") {
    // (1, 2, 3)·(2, 1, −1): 2 + 2 + 3, where the product itself is 1
    const Vec3<double> a{1, 2, 3}, b{2, 1, -1};
    CHECK_EXACT(dot(convert<Magnitude>(a), convert<Magnitude>(b)).size, 7.0);
    // (1, 1, 1) × (1, 1, 1) = 0, and each component takes 1 from 1
    const Vec3<double> one{1, 1, 1};
    CHECK_EXACT(cross(convert<Magnitude>(one), convert<Magnitude>(one)).z.size, 2.0);
}

// sides_error

TEST_CASE("the filter's bound is 8u S and a little more, S the largest sum of sizes") {
    // From the origin along (1, 1, 1), A = (3, 0, 0), B = (0, 5, 0), C = (0, 0, 7): the sides' sizes are 5·7, 7·3 and
    // 3·5; the largest is 35.
    const Triangle<double> triangle{{3, 0, 0}, {0, 5, 0}, {0, 0, 7}};
    const Ray<double> ray{{0, 0, 0}, {1, 1, 1}};
    CHECK_AT_LEAST(error_for(ray, triangle), 7 * u * 35);
    CHECK_AT_MOST(error_for(ray, triangle), 16 * u * 35);
    // With any direction that is as large, and as negative, it is the same; twice as long, twice that.
    CHECK_EXACT(error_for({{0, 0, 0}, {-1, 1, -1}}, triangle), error_for(ray, triangle));
    CHECK_EXACT(error_for({{0, 0, 0}, {2, 2, 2}}, triangle), 2 * error_for(ray, triangle));
    // Whichever side is the largest: with the corners in another order it is b, then c.
    const auto& [A, B, C] = triangle;
    CHECK_EXACT(error_for(ray, {C, A, B}), error_for(ray, triangle));
    CHECK_EXACT(error_for(ray, {B, C, A}), error_for(ray, triangle));
    // From (−10, −10, −10) A is seen at (13, 10, 10), B at (10, 15, 10), C at (10, 10, 17): a is (1, 1, 1)·(C × B) with
    // 15·17 + 10·10, 10·10 + 10·17 and 10·10 + 15·10, in all 875; b and c have less.
    CHECK_AT_LEAST(error_for({{-10, -10, -10}, {1, 1, 1}}, triangle), 7 * u * 875);
    CHECK_AT_MOST(error_for({{-10, -10, -10}, {1, 1, 1}}, triangle), 16 * u * 875);
}

TEST_CASE("the filter's bound is more than 8u S, also where S itself was rounded down") {
    // b = 2²⁷ + 1, b² = 2⁵⁴ + 2²⁸ + 1: doubles of this size are 4 apart, so S is computed as 2⁵⁴ + 2²⁸. 8u S is truly
    // 16 + 2⁻²² + 2⁻⁵⁰; the next double is 16 + 2⁻²² + 2⁻⁴⁸.
    const double b = 0x1p27 + 1;
    const Triangle<double> triangle{{0, 0, 0}, {0, b, 0}, {0, 0, b}};
    CHECK_AT_LEAST(error_for({{0, 0, 0}, {1, 1, 1}}, triangle), 16 + 0x1p-22 + 0x1p-48);
}

TEST_CASE("the filter's bound holds for the side products of any ray within reach, and is not loose") {
    Dice dice;
    for (const double size : {0x1p20, 0x1p30, 0x1p40}) {
        for (int n = 0; n < 200; ++n) {
            const Triangle<double> triangle{whole_vector(dice, size), whole_vector(dice, size),
                                            whole_vector(dice, size)};
            const Ray<double> ray{whole_vector(dice, size), whole_vector(dice, 0x1p40)};
            CHECK_AT_LEAST(error_for(ray, triangle), sides_off(ray, triangle));
            CHECK_AT_MOST(error_for(ray, triangle), 16 * u * sides_size(ray, triangle));
        }
    }
}

TEST_CASE("a small triangle seen from far away: the bound covers what the distance does") {
    // Some 2⁴ wide and 2⁴⁰ away: the terms are of size 2⁸⁰ and larger, and the side products are far smaller.
    Dice dice;
    for (int n = 0; n < 200; ++n) {
        const Vec3<double> at = whole_vector(dice, 0x1p40);
        const Triangle<double> triangle{whole_vector(dice, 16), whole_vector(dice, 16), whole_vector(dice, 16)};
        const Ray<double> ray{at, whole_vector(dice, 16) - at};
        CHECK_AT_LEAST(error_for(ray, triangle), sides_off(ray, triangle));
    }
}

TEST_CASE("one bound serves all rays within reach") {
    // found before the rays are known, from the largest of their coordinates
    Dice dice;
    const Triangle<double> triangle{whole_vector(dice, 0x1p40), whole_vector(dice, 0x1p40), whole_vector(dice, 0x1p40)};
    const double coordinate = 0x1p40;
    const Vec3<double> corner{coordinate, coordinate, coordinate};
    const double error = filter::sides_error(triangle, RayBounds{corner, corner});
    for (int n = 0; n < 200; ++n) {
        const Ray<double> ray{whole_vector(dice, coordinate), whole_vector(dice, coordinate)};
        CHECK_AT_LEAST(error, sides_off(ray, triangle));
        CHECK_AT_LEAST(error, error_for(ray, triangle));
    }
}

TEST_CASE("where numbers overflow or underflow the filter decides nothing: its bound is infinite") {
    const Triangle<double> triangle{{3, 0, 0}, {0, 5, 0}, {0, 0, 7}};
    const auto times = [&](double size) {
        return Triangle<double>{size * triangle.A, size * triangle.B, size * triangle.C};
    };
    const Ray<double> ray{{0, 0, 0}, {1, 1, 1}};
    // (2⁻⁴⁰⁰)² is 2⁻⁸⁰⁰, still a number; (2⁻⁶⁰⁰)² is 0 to a double, and 8u times 0 would be no bound at all
    CHECK_EXACT(error_for(ray, times(0x1p-600)), infinity);
    CHECK_EXACT(error_for(ray, times(0x1p600)), infinity);
    CHECK_EXACT(error_for({{0, 0, 0}, {0x1p-600, 0, 0}}, triangle), infinity);
    CHECK_EXACT(error_for({{0, 0, 0}, {0x1p600, 0, 0}}, triangle), infinity);
    // so it is from 2¹⁰⁰ on, in a corner and in the start, though 2⁴⁰⁰ is still a number
    CHECK_EXACT(error_for(ray, times(0x1p200)), infinity);
    CHECK_EXACT(error_for({{0x1p200, 0, 0}, {1, 1, 1}}, triangle), infinity);
    CHECK_AT_MOST(error_for(ray, times(0x1p-30)), 16 * u * 35 * 0x1p-60);  // and where they are just small, it is not
    CHECK_AT_MOST(error_for(ray, times(0x1p30)), 16 * u * 35 * 0x1p60);
}

TEST_CASE("from a coordinate of 2¹⁰⁰ on the filter decides nothing, whichever point has it") {
    for (std::size_t which = 0; which < 4; ++which) {  // A, B, C, and the ray's start
        CAPTURE(which);
        const auto error = [&](double coordinate) {
            std::array<Vec3<double>, 4> points{{{3, 0, 0}, {0, 5, 0}, {0, 0, 7}, {0, 0, 0}}};
            points[which].y = coordinate;
            const auto& [A, B, C, P] = points;
            return error_for({P, {1, 1, 1}}, {A, B, C});
        };
        CHECK_EXACT(error(0x1p100), infinity);
        CHECK_EXACT(error(-0x1p200), infinity);
        // Just below it does: the sides' sizes are some tens times 2¹⁰⁰, or times its square, and 9u is under 2⁻⁴⁹.
        CHECK_AT_MOST(error(std::nextafter(0x1p100, 0.0)), 0x1p200);
    }
    // nor where two are too large: 2²⁰⁰ and a direction of 2⁶⁰⁰
    const double large = 0x1p200, larger = 0x1p600;
    CHECK_EXACT(error_for({{0, 0, 0}, {larger, larger, larger}}, {{large, 0, 0}, {0, large, 0}, {0, 0, large}}),
                infinity);
    // nor where one is too large and all sides are 0, as of a triangle whose corners lie on one line with the start
    CHECK_EXACT(error_for({{0, 0, 0}, {1, 1, 1}}, {{large, 0, 0}, {1, 0, 0}, {2, 0, 0}}), infinity);
}

TEST_CASE("down to a size of 2⁻⁹⁰⁰ the filter decides nothing") {
    // From the origin along (d, d, d), with A = (s, 0, 0), B = (0, s, 0), C = (0, 0, s): each side's size is d s².
    const auto error = [](double d, double s) {
        return error_for({{0, 0, 0}, {d, d, d}}, {{s, 0, 0}, {0, s, 0}, {0, 0, s}});
    };
    CHECK_EXACT(error(1, 0x1p-450), infinity);
    CHECK_AT_MOST(error(2, 0x1p-450), 16 * u * 0x1p-899);  // twice as large it does
}
