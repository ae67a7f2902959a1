// BoundedPair keeps its promise, |true − (high + low)| ≤ error, and Unrounded its own, against numbers without any
// rounding.
#include "numerics/bounded_pair.hpp"

#include <doctest.h>

#include <algorithm>

#include "doubles.hpp"
#include "numerics/exact.hpp"
#include "numerics/unrounded.hpp"

using namespace glassbox;
using test::Doubles;

namespace {

/// A pair, and the number that it stands for.
struct Stands {
    BoundedPair pair;
    Exact truth;
};

Stands operator+(const Stands& a, const Stands& b) { return {a.pair + b.pair, a.truth + b.truth}; }
Stands operator-(const Stands& a, const Stands& b) { return {a.pair - b.pair, a.truth - b.truth}; }
Stands operator*(const Stands& a, const Stands& b) { return {a.pair * b.pair, a.truth * b.truth}; }
Stands operator/(const Stands& a, const Stands& b) { return {a.pair / b.pair, a.truth / b.truth}; }
Stands root(const Stands& a) { return {sqrt(a.pair), sqrt(a.truth)}; }

Stands stands(double x) { return {BoundedPair(x), Exact(x)}; }

/// |true − value| ≤ error as `to_bounded` has them, or nothing is known.
bool holds(const Stands& one) {
    const Bounded b = one.pair.to_bounded();
    if (!is_known(b)) return true;
    return compare(abs(one.truth - Exact(b.value)), Exact(b.error)) <= 0;
}

bool is_zero(const Exact& a) { return a.sign() == 0; }

/// A few operations on a few numbers; `size` makes them.
template <class Make>
Stands formula(Doubles& random, const Make& make) {
    Stands sum = stands(make());
    for (int n = 0; n < 5; ++n) {
        const Stands other = stands(make());
        switch (random.below(4)) {
            case 0:
                sum = sum + other * stands(make());
                break;
            case 1:
                sum = sum - other;
                break;
            case 2:
                sum = sum * (other + stands(make()));
                break;
            default:
                if (!is_zero(other.truth)) sum = sum / other;
        }
    }
    return sum;
}

}  // namespace

TEST_CASE("BoundedPair: the true number lies within the bound, of ordinary numbers much within a double's last digit") {
    Doubles random(21);
    int wrong = 0, sharp = 0;
    constexpr int rounds = 3000;
    for (int i = 0; i < rounds; ++i) {
        const Stands one = formula(random, [&] { return random.sign() * random.positive(-20, 20); });
        wrong += !holds(one);
        const Bounded b = one.pair.to_bounded();
        sharp += b.error <= 0x1p-52 * std::abs(b.value);
    }
    CHECK(wrong == 0);
    // Five operations lose 2⁻¹⁰⁰ of the largest number among them, which cancellation would have to make as small as
    // 2⁻⁵³ of it before the double nearest to the sum were in doubt.
    CHECK(sharp > rounds * 9 / 10);
}

TEST_CASE("BoundedPair: the true number lies within the bound where numbers overflow or underflow") {
    Doubles random(22);
    int wrong = 0;
    for (int i = 0; i < 3000; ++i) wrong += !holds(formula(random, [&] { return random.any(); }));
    CHECK(wrong == 0);
}

TEST_CASE("BoundedPair: roots") {
    Doubles random(23);
    int wrong = 0, sharp = 0;
    for (int i = 0; i < 500; ++i) {
        const Stands x = stands(random.positive(-200, 200)) + stands(random.positive(-260, 100));
        const Stands r = root(x);
        wrong += !holds(r);
        const Bounded b = r.pair.to_bounded();
        sharp += b.error <= 0x1p-52 * b.value;  // half of its last digit, at most
    }
    CHECK(wrong == 0);
    CHECK(sharp == 500);
}

TEST_CASE("BoundedPair: what a comparison is sure of is so, and numbers that differ by 2⁻⁹⁰ are told apart") {
    Doubles random(24);
    int wrong = 0, undecided = 0;
    for (int i = 0; i < 3000; ++i) {
        const double x = random.sign() * random.positive(-20, 20), y = random.positive(-20, 20);
        // xy and xy(1 + 2⁻⁹⁰): the factor is a sum of two doubles.
        const Stands a = stands(x) * stands(y), b = a * (stands(1) + stands(0x1p-90));
        const Kleene less = a.pair < b.pair;
        if (surely(less) || !possibly(less)) wrong += surely(less) != (compare(a.truth, b.truth) < 0);
        else ++undecided;
        wrong += !possibly(a.pair == a.pair) || surely(a.pair < a.pair);
    }
    CHECK(wrong == 0);
    CHECK(undecided == 0);
}

TEST_CASE("Unrounded: what it calls exact is, and on a grid it says so") {
    Doubles random(25);
    int wrong = 0, exact = 0;
    constexpr int rounds = 3000;
    for (int i = 0; i < rounds; ++i) {
        // Whole numbers below 2¹⁵, in half of the cases: products of three and their sums are below 2⁵³.
        const bool on_grid = i % 2 == 0;
        const auto make = [&] { return on_grid ? static_cast<double>(random.below(32768)) - 16384 : random.any(); };
        const double a = make(), b = make(), c = make(), d = make();
        const Unrounded s = Unrounded(a) * Unrounded(b) * Unrounded(c) - Unrounded(d) * (Unrounded(a) + Unrounded(b));
        const Exact truth = Exact(a) * Exact(b) * Exact(c) - Exact(d) * (Exact(a) + Exact(b));
        if (s.is_exact()) wrong += compare(truth, Exact(s.value())) != 0;
        exact += on_grid && s.is_exact();
    }
    CHECK(wrong == 0);
    CHECK(exact == rounds / 2);
}
