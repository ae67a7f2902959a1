// Replaying a tape: bounds that hold, true values, lost bits.
#include "explain/replay.hpp"

#include <doctest.h>

#include <cmath>
#include <intersect_sphere.hpp>
#include <limits>
#include <moeller_trumbore.hpp>
#include <probe.hpp>
#include <random>
#include <shade_by_model.hpp>
#include <tolerance.hpp>

#include "numerics/recorded.hpp"
#include "support/ulps.hpp"

using namespace glassbox;

namespace {

/// The bound must hold at every step.
void check_bounds(const Tape& tape) {
    for (const Checked& checked : replay(tape)) {
        if (checked.known == Known::not_at_all) continue;
        CHECK(checked.distance <= checked.error);
        CHECK(checked.bits_lost >= 0);
    }
}

}  // namespace

// In units of 2^-56, 0.1 is n = 0x1999999999999a, 0.2 is 2n, and 0.3 is 4·0x13333333333333 = 3n − 2. So the truth of
// (0.1 + 0.2) − 0.3 is 2^-55. The sum rounds up to 0.3 + 2^-54, and the difference is 2^-54: off by 2^-55, which is
// 2^51 of its last places, of 2^-106 each.
TEST_CASE("0.1 + 0.2 - 0.3: one rounding, and 51 bits are lost") {
    Tape tape;
    const Recorded<double> a = Recorded<double>::input(tape, 0.1, "a"), b = Recorded<double>::input(tape, 0.2, "b");
    const Recorded<double> sum = a + b;
    const Recorded<double> difference = sum - Recorded<double>::input(tape, 0.3, "c");
    const std::vector<Checked> checked = replay(tape);
    const Checked& last = checked[difference.step()];
    CHECK(last.value == 0x1p-54);
    CHECK(last.truth == 0x1p-55);
    CHECK(last.distance == 0x1p-55);
    CHECK(last.error >= last.distance);
    CHECK(last.error <= 8 * last.distance);
    CHECK(last.known == Known::exactly);
    CHECK(last.bits_lost == doctest::Approx(51).epsilon(1e-9));
    CHECK(checked[sum.step()].bits_lost < 1);
    CHECK(checked[a.step()].bits_lost == 0);
    CHECK(checked[a.step()].error == 0);
}

// With x = 1 + 2^-13, x² = 1 + 2^-12 + 2^-26. A float near 1 has last places of 2^-23, so the last term is rounded
// away: 1/8 of a place. x² − 1 is 2^-12 then, without a rounding; truly 2^-26 more, which is 2^9 last places of 2^-12,
// 2^-35 each. No float is nearer to x² than the one that was subtracted from: all of this loss is the difference's own.
// The true x² − 1 is a float, so that 3 (x² − 1) would be right if it were given it: its loss, 3·2^-26 in last places
// of 2^-34, is inherited. (x − 1)(x + 1) loses nothing.
TEST_CASE("x² − y²: the difference's loss is its own, and what goes on from it inherits it") {
    Tape tape(Precision::of<float>());
    const Recorded<float> x = Recorded<float>::input(tape, 1 + 0x1p-13, "x");
    const Recorded<float> square = x * x, difference = square - 1.f, three = 3.f * difference;
    const Recorded<float> factored = (x - 1.f) * (x + 1.f);
    const std::vector<Checked> checked = replay(tape);
    const auto own = [&](const Recorded<float>& n) { return checked[n.step()].own_loss; };
    const auto inherited = [&](const Recorded<float>& n) { return checked[n.step()].inherited_loss; };
    CHECK(own(square) == doctest::Approx(std::log2(1 + 1. / 8)));
    CHECK(inherited(square) == 0);
    CHECK(difference.value() == 0x1p-12f);
    CHECK(own(difference) == doctest::Approx(std::log2(512. + 1)));
    CHECK(inherited(difference) == 0);
    CHECK(own(three) == 0);
    CHECK(inherited(three) == doctest::Approx(std::log2(3 * 256. + 1)));
    CHECK(factored.value() == 0x1p-12f + 0x1p-26f);
    CHECK(own(factored) == 0);
    CHECK(inherited(factored) == 0);
    CHECK(own(x) == 0);
}

// 1/3 is 0x1.5555555555555|5…p-2: a third of a last place is lost. Three times that rounds to 1, which is true, so that
// nothing of the loss is left.
TEST_CASE("a loss may vanish again; what has no true value has no own loss") {
    Tape tape;
    const Recorded<double> one = Recorded<double>::input(tape, 1, "one"), zero = Recorded<double>::input(tape, 0, "0");
    const Recorded<double> third = one / 3, again = 3 * third, none = one / zero, next = none + one;
    const std::vector<Checked> checked = replay(tape);
    CHECK(checked[third.step()].own_loss == doctest::Approx(std::log2(4. / 3)));
    CHECK(checked[again.step()].own_loss == 0);
    CHECK(checked[again.step()].inherited_loss == 0);
    for (const Recorded<double>& number : {none, next}) {
        CHECK(std::isnan(checked[number.step()].own_loss));
        CHECK(std::isnan(checked[number.step()].inherited_loss));
    }
}

// own is best − truth, inherited is value − best: the error in last places is at most the sum of both.
TEST_CASE("own and inherited losses cover the whole loss") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> coordinate(-400, 400);
    for (int i = 0; i < 200; ++i) {
        Tape tape(Precision::of<float>());
        const Silent silent;
        const Ray<Recorded<float>> ray{input<float>(tape, {coordinate(random), coordinate(random), 900}, "P"),
                                       input<float>(tape, {0.1, -0.2, -1}, "D")};
        const Sphere<Recorded<float>> sphere{input<float>(tape, {coordinate(random), coordinate(random), 0}, "c"),
                                             Recorded<float>::input(tape, 333.3, "r")};
        (void)intersect(ray, sphere, Textbook{}, silent);
        for (const Checked& one : replay(tape)) {
            if (std::isnan(one.own_loss) || one.bits_lost >= 24 || one.own_loss >= 24 || one.inherited_loss >= 24)
                continue;
            // Last places of two numbers that differ much may differ in size by a power of 2.
            CHECK(std::exp2(one.bits_lost) - 1 <=
                  (2 * (std::exp2(one.own_loss) - 1) + std::exp2(one.inherited_loss) - 1) * (1 + 1e-9));
        }
    }
}

TEST_CASE("one root is exact, a root of a root is a long float, and a division by 0 is nothing") {
    Tape tape;
    const Recorded<double> two = Recorded<double>::input(tape, 2, "two"),
                           zero = Recorded<double>::input(tape, 0, "zero");
    const Recorded<double> root = sqrt(two), nested = sqrt(1 + root), none = two / zero, square = root * root - two;
    const std::vector<Checked> checked = replay(tape);
    CHECK(checked[root.step()].known == Known::exactly);
    CHECK(checked[nested.step()].known == Known::to_long_float);
    CHECK_ULPS(checked[nested.step()].truth, 1.5537739740300374, 1.0);  // √(1 + √2)
    CHECK(checked[none.step()].known == Known::not_at_all);
    CHECK(std::isinf(checked[none.step()].error));
    CHECK(checked[square.step()].value != 0);
    CHECK(checked[square.step()].truth == 0);
    CHECK(checked[square.step()].sign == 0);
    CHECK(checked[square.step()].bits_lost > 50);
}

// (1 + √2)² = 3 + 2√2, so √(3 + 2√2) − (1 + √2) is 0; but that is a root of a root less a root, and long floats have
// 320 bits. So 2^-200 beside it is seen, and 2^-330 is not.
TEST_CASE("a cancellation to 0 that long floats cannot prove claims no value, no sign and no lost bits") {
    Tape tape;
    const auto input = [&](double value) { return Recorded<double>::input(tape, value, "x"); };
    const Recorded<double> root = sqrt(input(2)), nothing = sqrt(3 + 2 * root) - (1 + root);
    const Recorded<double> seen = nothing + 0x1p-200, unseen = nothing + 0x1p-330;
    const Recorded<double> hangs_on_it = input(1) / nothing, product = nothing * 0.0, size = abs(nothing);
    const Recorded<double> power = pow(size, 3.0);
    const bool above = nothing > 0.0;
    const auto comparison = static_cast<StepNumber>(tape.steps().size() - 1);
    const std::vector<Checked> checked = replay(tape);
    for (const Recorded<double>& number : {nothing, unseen, size}) {
        const Checked& zero = checked[number.step()];
        CHECK(zero.known == Known::to_long_float);
        CHECK(may_be_zero(zero));
        CHECK(zero.truth == 0);
        CHECK(std::isnan(zero.bits_lost));
        CHECK(zero.distance <= zero.error);
    }
    CHECK(checked[seen.step()].sign == 1);
    CHECK_ULPS(checked[seen.step()].truth, 0x1p-200, 1.0);
    for (const StepNumber step : {hangs_on_it.step(), power.step(), comparison})
        CHECK(checked[step].known == Known::not_at_all);
    CHECK(tape[comparison].value == above);
    CHECK(checked[product.step()].known == Known::exactly);
    CHECK(checked[product.step()].truth == 0);
}

TEST_CASE("a truth that long floats do not tell from the number has lost no bit") {
    Tape tape;
    const Recorded<double> nested =
        sqrt(Recorded<double>::input(tape, 4, "4") * sqrt(Recorded<double>::input(tape, 16, "16")));
    const std::vector<Checked> checked = replay(tape);
    const Checked& four = checked[nested.step()];  // √(4 √16) = 4, by a root of a root
    CHECK(four.value == 4);
    CHECK(four.known == Known::to_long_float);
    CHECK(four.sign == 1);
    CHECK(four.truth == 4);
    CHECK(four.distance == 0);
    CHECK(four.bits_lost == 0);
}

TEST_CASE("a root that truly is none has no bound") {
    Tape tape(Precision::of<float>());
    const auto one = Recorded<float>::input(tape, 1, "1"), less = Recorded<float>::input(tape, -1 - 0x1p-40, "less");
    const Recorded<float> sum = one + less, root = sqrt(sum);  // -1 - 2^-40 is no float: the sum is 0, truly -2^-40
    const std::vector<Checked> checked = replay(tape);
    CHECK(checked[sum.step()].value == 0);
    CHECK(checked[sum.step()].truth == -0x1p-40);
    CHECK(checked[root.step()].value == 0);
    CHECK(checked[root.step()].known == Known::not_at_all);
    CHECK(std::isinf(checked[root.step()].error));
}

TEST_CASE("powers: within bounds, whatever is not known of the base") {
    Tape tape;
    const Recorded<double> third = Recorded<double>::input(tape, 1, "1") / 3;
    const Recorded<double> power = pow(third, 15);  // 3^-15 = 1/14348907
    const std::vector<Checked> checked = replay(tape);
    CHECK_ULPS(checked[power.step()].truth, 1.0 / 14348907, 1.0);
    CHECK(checked[power.step()].distance <= checked[power.step()].error);
    CHECK(checked[power.step()].error < 1e-20);
}

TEST_CASE("whether a comparison truly holds, and whether the bounds know it") {
    Tape tape;
    const Recorded<double> sum =
        Recorded<double>::input(tape, 0.1, "a") + Recorded<double>::input(tape, 0x1p-60, "tiny");
    CHECK_FALSE(sum > 0.1);
    CHECK(sum > 0.05);
    const std::vector<Checked> checked = replay(tape);
    std::vector<Checked> comparisons;
    for (std::size_t i = 0; i < checked.size(); ++i)
        if (is_comparison(tape.steps()[i].operation)) comparisons.push_back(checked[i]);
    REQUIRE(comparisons.size() == 2);
    CHECK(comparisons[0].value == 0);
    CHECK(comparisons[0].truth == 1);
    CHECK(comparisons[0].error == 1);
    CHECK(comparisons[1].truth == 1);
    CHECK(comparisons[1].error == 0);
}

TEST_CASE_TEMPLATE("bounds hold on every step of the core's formulas", Real, float, double, long double) {
    std::mt19937_64 random(1105);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    const auto vector = [&](double size) {
        return Vec3<double>{size * coordinate(random), size * coordinate(random), size * coordinate(random)};
    };
    const Silent silent;
    for (int i = 0; i < 40; ++i) {
        Tape tape(Precision::of<Real>());
        const double size = std::ldexp(1.0, 8 * (i % 5) - 16);
        const Ray<Recorded<Real>> ray{input<Real>(tape, vector(size), "P"), input<Real>(tape, vector(1), "D")};
        const Sphere<Recorded<Real>> sphere{input<Real>(tape, vector(1), "c"), Recorded<Real>::input(tape, 0.5, "r")};
        const Crossing<Recorded<Real>> crossing = intersect(ray, sphere, Stable{}, silent);
        intersect(ray, sphere, Textbook{}, silent);
        const Triangle<Recorded<Real>> triangle{input<Real>(tape, vector(1), "A"), input<Real>(tape, vector(1), "B"),
                                                input<Real>(tape, vector(size), "C")};
        intersect(ray, triangle, Pluecker{}, silent);
        intersect(ray, triangle, Tolerance{}, silent);
        intersect(ray, triangle, MoellerTrumbore{}, silent);
        const Vec3<Recorded<Real>> n = crossing.met ? normal(sphere, at(ray, crossing.t)) : normal(triangle);
        const Shading<Recorded<Real>> shading{
            ShadingModel::blinn_phong, .2, 1, .2, 15, {255, 102, 102}, {255, 255, 255}};
        const Light<Recorded<Real>> light = directional_light(input<Real>(tape, vector(100), "L"), 1);
        shade_by_model(n, unit(-ray.D), {10, 200, 30}, light, shading, silent);
        check_bounds(tape);
    }
}

// 0.1 is no float: the scene's double is rounded when it becomes one. 1/3 = 0x0.555... is, in any number of bits, a
// third of the last place off. By the case above 3·0.1 − 0.3 is 2^-55 for these doubles. In float it is 0: 3·0.1 rounds
// to the float nearest to 0.3. So no bit of it is right.
TEST_CASE("in float, bits are float's, and rounding an input to float is a step") {
    Tape tape(Precision::of<float>());
    const auto tenth = Recorded<float>::input(tape, 0.1, "tenth"), three = Recorded<float>::input(tape, 3, "three");
    CHECK(tenth.value() == 0.1F);
    CHECK(tape[tenth.step()].operation == Operation::round);
    CHECK(tape[tape[tenth.step()].left].value == 0.1);
    CHECK(tape[three.step()].operation == Operation::input);
    const auto third = 1 / three, nothing = three - 3,
               lost = (tenth * three - Recorded<float>::input(tape, 0.3, "0.3"));
    CHECK(third.value() == 1 / 3.0F);
    const std::vector<Checked> checked = replay(tape);
    CHECK(checked[tenth.step()].truth == 0.1);
    CHECK(checked[tenth.step()].bits_lost > 0);
    CHECK(checked[tenth.step()].bits_lost <= std::log2(1.5));  // rounding is off by half a unit at most
    CHECK(checked[third.step()].bits_lost == doctest::Approx(std::log2(1 + 1 / 3.0)).epsilon(1e-6));
    CHECK(checked[nothing.step()].bits_lost == 0);
    CHECK(checked[lost.step()].value == 0);
    CHECK(checked[lost.step()].truth == 0x1p-55);
    CHECK(checked[lost.step()].bits_lost == 24);
    for (const Checked& step : checked) CHECK(step.distance <= step.error);
}

// 1/3 is again a third of the last place off. 3e600 and 3e-600 are beyond a double, and may be none beyond a long
// double: two roundings of half a unit each make less than 2 bits.
TEST_CASE("in long double, bits are long double's, and its tape has all of them") {
    Tape tape(Precision::of<long double>());
    const auto three = Recorded<long double>::input(tape, 3, "three");
    const auto third = 1 / three, large = three * 1e300 * 1e300, small = three * 1e-300 * 1e-300;
    CHECK(tape[third.step()].value == 1 / 3.0L);
    const std::vector<Checked> checked = replay(tape);
    CHECK(checked[third.step()].recorded == 1 / 3.0L);
    CHECK(checked[third.step()].value == 1 / 3.0);
    CHECK(checked[third.step()].bits_lost == doctest::Approx(std::log2(1 + 1 / 3.0)).epsilon(1e-6));
    CHECK(checked[third.step()].distance <= checked[third.step()].error);
    if (std::numeric_limits<long double>::max_exponent > std::numeric_limits<double>::max_exponent) {
        CHECK(std::isinf(checked[large.step()].value));
        CHECK(std::isfinite(checked[large.step()].recorded));
        CHECK(checked[large.step()].bits_lost < 2);
        CHECK(checked[small.step()].value == 0);
        CHECK(checked[small.step()].recorded > 0);
        CHECK(checked[small.step()].bits_lost < 2);
    }
}
