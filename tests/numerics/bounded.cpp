// Bounded keeps its promise, |true − value| ≤ error, checked with integers, which are never rounded.
#include <bounded.hpp>
#include <magnitude.hpp>

#include <doctest.h>

#include <algorithm>
#include <functional>
#include <pluecker.hpp>
#include <sstream>
#include <vector>

#include "doubles.hpp"
#include "fixed_point.hpp"

using namespace glassbox;
using test::Doubles, test::fixed_point, test::one, test::Whole;

namespace {

#ifdef NDEBUG
constexpr int rounds = 400'000;
#else
constexpr int rounds = 40'000;
#endif

std::string shown(const Bounded& b) {
    std::ostringstream out;
    out << std::hexfloat << b.value << " ± " << b.error;
    return out.str();
}

/// A Bounded, and a number that it may stand for, as a fixed-point integer.
struct Stands {
    Bounded bounded;
    Whole truth;
};

/// Errors of every kind: none, half an ulp, a few subnormals, small, as large as the value, larger.
double any_error(Doubles& random, double value) {
    const double size = std::abs(value);
    switch (random.below(7)) {
        case 0:
        case 1:
            return 0;
        case 2:
            return 0x1p-53 * size;
        case 3:
            return static_cast<double>(random.below(4)) * 0x1p-1074;
        case 4:
            return std::ldexp(size, -static_cast<int>(random.below(60)));
        case 5:
            return size * (1 - random.fraction() * 0x1p-40);
        default:
            return random.positive(-1074, 1000);
    }
}

/// The truth lies at an end of what the bound allows, in the middle, or anywhere between.
Stands any_stands(Doubles& random, double value) {
    const double error = any_error(random, value);
    const Whole e = fixed_point(error);
    Whole truth = fixed_point(value);
    switch (random.below(4)) {
        case 0:
            truth += e;
            break;
        case 1:
            truth -= e;
            break;
        case 2:
            truth += e * (static_cast<long long>(random.below(201)) - 100) / 100;
            break;
        default:
            break;
    }
    return {{value, error}, truth};
}

Stands any_stands(Doubles& random) { return any_stands(random, random.any()); }

/// Whether |truth − value| ≤ error holds for the truth numerator / denominator.
bool holds(const Bounded& answer, const Whole& numerator, const Whole& denominator) {
    if (!is_known(answer)) return true;
    if (!(answer.error >= 0)) return false;
    return abs(Whole(numerator - fixed_point(answer.value) * denominator)) <=
           fixed_point(answer.error) * abs(denominator);
}

/// As above, for √truth: squaring is exact.
bool holds_for_root(const Bounded& answer, const Whole& truth) {
    if (!is_known(answer)) return true;
    const Whole least = fixed_point(answer.value) - fixed_point(answer.error);
    const Whole most = fixed_point(answer.value) + fixed_point(answer.error);
    const Whole square = truth * one();
    return most >= 0 && square <= most * most && (least <= 0 || least * least <= square);
}

/// Two numbers likely to defeat any shortcut: unrelated, or of nearly one size, or nearly equal.
std::pair<Stands, Stands> any_pair(Doubles& random) {
    const Stands a = any_stands(random);
    switch (random.below(4)) {
        case 0:
            return {a, any_stands(random, random.sign() * a.bounded.value)};
        case 1:
            return {a, any_stands(random, std::nextafter(random.sign() * a.bounded.value, 0))};
        case 2: {
            const double near = std::ldexp(random.mantissa(), std::max(-1074, std::ilogb(a.bounded.value)));
            return {a, any_stands(random, std::isfinite(near) && a.bounded.value != 0 ? near : 1)};
        }
        default:
            return {a, any_stands(random)};
    }
}

}  // namespace

TEST_CASE("every operation holds, wherever in their bounds the true operands lie") {
    Doubles random(1);
    int known = 0;
    for (int i = 0; i < rounds; ++i) {
        const auto pair = any_pair(random);
        const Stands &a = pair.first, &b = pair.second;
        CAPTURE(shown(a.bounded));
        CAPTURE(shown(b.bounded));
        const Bounded sum = a.bounded + b.bounded, difference = a.bounded - b.bounded, product = a.bounded * b.bounded,
                      quotient = a.bounded / b.bounded;
        REQUIRE_MESSAGE(holds(sum, a.truth + b.truth, 1), shown(sum));
        REQUIRE_MESSAGE(holds(difference, a.truth - b.truth, 1), shown(difference));
        REQUIRE_MESSAGE(holds(product, a.truth * b.truth, one()), shown(product));
        if (b.truth != 0) REQUIRE_MESSAGE(holds(quotient, a.truth * one(), b.truth), shown(quotient));
        REQUIRE(holds(-a.bounded, -a.truth, 1));
        REQUIRE(holds(abs(a.bounded), abs(a.truth), 1));
        if (a.truth >= 0) REQUIRE_MESSAGE(holds_for_root(sqrt(a.bounded), a.truth), shown(sqrt(a.bounded)));
        known += is_known(sum) && is_known(product) && is_known(quotient);
    }
    CHECK(known > rounds / 10);
}

TEST_CASE("operations hold where results become subnormal, and bounds with them") {
    Doubles random(2);
    for (int i = 0; i < rounds; ++i) {
        // A sum of tiny numbers: its error is a few subnormals, too small to survive a careless product.
        const double x = random.sign() * random.positive(-1060, -1000),
                     y = random.sign() * random.positive(-1060, -1000);
        const Bounded sum = Bounded(x) + Bounded(y);
        const Whole truth = fixed_point(x) + fixed_point(y);
        const double z = random.sign() * random.positive(-1040, -980);
        CAPTURE(x);
        CAPTURE(y);
        CAPTURE(z);
        REQUIRE(holds(sum, truth, 1));
        REQUIRE(holds(sum * Bounded(z), truth * fixed_point(z), one()));
        REQUIRE(holds(sum / Bounded(z), truth * one(), fixed_point(z)));
        if (truth != 0)
            REQUIRE_MESSAGE(holds(Bounded(z) / sum, fixed_point(z) * one(), truth), shown(Bounded(z) / sum));
        if (truth >= 0) REQUIRE(holds_for_root(sqrt(sum), truth));
    }
}

TEST_CASE("a comparison that decides is right") {
    Doubles random(3);
    int decided = 0, undecided = 0;
    for (int i = 0; i < rounds; ++i) {
        const auto pair = any_pair(random);
        const Stands &a = pair.first, &b = pair.second;
        const auto right = [&](Kleene answer, bool truth) {
            surely(answer) == possibly(answer) ? ++decided : ++undecided;
            return truth ? possibly(answer) : !surely(answer);
        };
        CAPTURE(shown(a.bounded));
        CAPTURE(shown(b.bounded));
        REQUIRE(right(a.bounded < b.bounded, a.truth < b.truth));
        REQUIRE(right(a.bounded > b.bounded, a.truth > b.truth));
        REQUIRE(right(a.bounded <= b.bounded, a.truth <= b.truth));
        REQUIRE(right(a.bounded >= b.bounded, a.truth >= b.truth));
        REQUIRE(right(a.bounded == b.bounded, a.truth == b.truth));
        REQUIRE(right(a.bounded != b.bounded, a.truth != b.truth));
    }
    CHECK(decided > rounds);  // of the 6 · rounds comparisons
    CHECK(undecided > rounds / 10);
}

TEST_CASE("comparisons of numbers without error are decided; unknown ones never") {
    for (const double x : {0.0, -0.0, 1.0, 0x1p-1074, -0x1p1023, 0x1.fffffffffffffp1023}) {
        CHECK(surely(Bounded(x) == Bounded(x)));
        CHECK(surely(Bounded(x) <= Bounded(x)));
        CHECK(!possibly(Bounded(x) < Bounded(x)));
    }
    CHECK(surely(Bounded(1) < Bounded(1 + 0x1p-52)));
    CHECK(surely(Bounded(-0x1.8p1023) < Bounded(0x1.8p1023)));
    const Bounded overflowed = Bounded(0x1p1000) * Bounded(0x1p1000);
    const Bounded by_zero = Bounded(1) / Bounded(1e-30, 1e-30);
    const Bounded not_a_number = overflowed - overflowed;
    for (const Bounded& unknown :
         {overflowed, by_zero, not_a_number, overflowed * Bounded(1e-300), by_zero + Bounded(1), sqrt(overflowed),
          Bounded(1) / by_zero, sqrt(not_a_number), abs(-overflowed)}) {
        CHECK(!is_known(unknown));
        for (const Kleene answer : {unknown<Bounded(0), unknown> Bounded(0), unknown == Bounded(0),
                                    unknown != Bounded(0), unknown <= unknown})
            CHECK((!surely(answer) && possibly(answer)));
    }
    CHECK(surely(overflowed * Bounded(0) == Bounded(0)));  // a true number times 0, however large
}

namespace {

/// A fraction p/q, not reduced: trees are shallow.
struct Fraction {
    Whole p, q = 1;
};

/// An expression computed both ways at once. A root is followed by the lower end of an interval 2⁻⁴⁰⁰ wide that the
/// bound has been shown to contain: what comes after must hold for that number, too.
struct Tree {
    Bounded bounded;
    Fraction truth;
};

Tree any_tree(Doubles& random, int depth, int least, int most) {
    if (depth == 0) {
        const double x = random.one_in(12) ? 0 : random.sign() * random.positive(least, most);
        return {Bounded(x), {fixed_point(x), one()}};
    }
    const Tree a = any_tree(random, depth - 1, least, most);
    // Sometimes a itself: x − x, x/x and (x + y)·(x − y) cancel to the last bit.
    const Tree b = random.one_in(4) ? a : any_tree(random, depth - 1, least, most);
    const auto& [p, q] = a.truth;
    const auto& [r, s] = b.truth;
    switch (random.below(6)) {
        case 0:
            return {a.bounded + b.bounded, {p * s + r * q, q * s}};
        case 1:
            return {a.bounded - b.bounded, {p * s - r * q, q * s}};
        case 2:
            return {a.bounded * b.bounded, {p * r, q * s}};
        case 3:
            return r == 0 ? a : Tree{a.bounded / b.bounded, {p * s, q * r}};
        case 4:
            return {abs(a.bounded), {abs(p), abs(q)}};
        default: {
            const Bounded root = sqrt(abs(a.bounded));
            const Whole P = abs(p), Q = abs(q);
            // |√(P/Q) − value| ≤ error, squared; value and error in units of 2⁻¹⁰⁷⁴.
            if (is_known(root)) {
                const Whole low = fixed_point(root.value) - fixed_point(root.error);
                const Whole high = fixed_point(root.value) + fixed_point(root.error);
                const Whole square = P * one() * one();
                REQUIRE(square <= high * high * Q);
                if (low > 0) REQUIRE(low * low * Q <= square);
            }
            const Whole scaled = sqrt(Whole((P * Q) << 800));
            return {root, {scaled, Q << 400}};
        }
    }
}

}  // namespace

TEST_CASE("whole expressions hold: three operations deep, from the smallest numbers to the largest") {
    Doubles random(4);
    int known = 0;
    constexpr int trees = rounds / 40;
    for (int i = 0; i < trees; ++i) {
        const bool ordinary = i % 2 == 0;
        const Tree tree = any_tree(random, 3, ordinary ? -3 : -1000, ordinary ? 3 : 1000);
        // A root of a root is only approximated: allow it 2⁻⁹⁰⁰.
        const auto& [p, q] = tree.truth;
        const Bounded& b = tree.bounded;
        if (!is_known(b)) continue;
        ++known;
        CAPTURE(shown(b));
        REQUIRE(abs(Whole(p - fixed_point(b.value) * q / one())) <= (fixed_point(b.error) * abs(q)) / one() + 1);
    }
    CHECK(known > trees / 4);
}

TEST_CASE("zero stays exactly zero") {
    const Bounded zero(0), some(3, 1);
    for (const Bounded& b : {zero * some, some * zero, zero / some, sqrt(zero), zero + zero, -zero}) {
        CHECK(b.value == 0);
        CHECK(b.error <= Bounded::underflow);
    }
    CHECK((zero * some).error == 0);
    CHECK((zero / some).error == 0);
}

TEST_CASE(
    "bounds are honest: a side product's is within 20 of its terms' sizes, and rarely more than 60 of the error") {
    // s = D·(B × A): 9 products and 8 sums of sizes that add up to at most P each; u = 2⁻⁵³.
    Doubles random(5);
    std::vector<double> ratios;
    for (int i = 0; i < 20'000; ++i) {
        const auto vector = [&]<class Real>(const double(&c)[3], std::type_identity<Real>) {
            return Vec3<Real>{Real(c[0]), Real(c[1]), Real(c[2])};
        };
        double c[3][3];
        for (auto& row : c)
            for (double& x : row) x = random.sign() * random.fraction();
        const auto in = [&]<class Real>(std::type_identity<Real> real) {
            return side(vector(c[0], real), vector(c[1], real), vector(c[2], real));
        };
        const Bounded s = in(std::type_identity<Bounded>{});
        const double P = in(std::type_identity<Magnitude>{}).size;
        REQUIRE(s.error <= 20 * Bounded::u * P);
        Whole truth = 0;  // the determinant, in units of 2⁻³²²²; fixed_point counts in 2⁻¹⁰⁷⁴
        for (int k = 0; k < 3; ++k) {
            const int l = (k + 1) % 3, m = (k + 2) % 3;
            const auto at = [&](int row, int column) { return fixed_point(c[row][column]); };
            truth += at(0, k) * (at(2, l) * at(1, m) - at(2, m) * at(1, l));
        }
        const Whole unit = one() * one();
        const Whole error = abs(Whole(truth - fixed_point(s.value) * unit));
        REQUIRE(error <= fixed_point(s.error) * unit);
        if (error != 0) ratios.push_back(static_cast<double>(Whole(fixed_point(s.error) * unit * 16 / error)) / 16);
    }
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    MESSAGE("bound over true error of a side product, in the median: " << *middle);
    CHECK(*middle < 60);
}
