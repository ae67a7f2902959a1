// Whatever a formula may come to in a scalar, however it is rounded, lies within its enclosure.
#include "numerics/enclosure.hpp"

#include <doctest.h>

#include <cmath>
#include <random>

#include <quadratic.hpp>
#include <sides.hpp>

#include "compare/their_shading.hpp"

using namespace glassbox;

namespace {

template <class Real>
bool holds(const Enclosure<Real>& all, long double number) {
    const auto& [value, error] = all.range();
    return std::abs(number - static_cast<long double>(value)) <= static_cast<long double>(error);
}

template <class Real>
bool is_exactly(const Enclosure<Real>& all, double number) {
    return all.range().value == number && all.range().error == 0;
}

/// Numbers as scenes have them: of a few sizes, positive and negative.
class Numbers {
public:
    double operator()() {
        const double mantissa = std::uniform_real_distribution(-1.0, 1.0)(random_);
        return std::ldexp(mantissa, static_cast<int>(random_() % 12));
    }
    Vec3<double> vector() {
        const double x = (*this)(), y = (*this)(), z = (*this)();
        return {x, y, z};
    }

private:
    std::mt19937_64 random_{2014};
};

/// a·b as a compiler contracts it: each product but one goes into a sum without being rounded.
template <class Real>
Real contracted_dot(const Vec3<Real>& a, const Vec3<Real>& b) {
    return std::fma(a.z, b.z, std::fma(a.y, b.y, a.x * b.x));
}

}  // namespace

TEST_CASE_TEMPLATE("side products and discriminants, rounded, contracted and hardly rounded, lie within", Real, float,
                   double) {
    using Number = Enclosure<Real>;
    Numbers number;
    for (int i = 0; i < 20000; ++i) {
        const Vec3<double> D = number.vector(), A = number.vector(), B = number.vector();
        const Number all = side(convert<Number>(D), convert<Number>(A), convert<Number>(B));
        const Vec3<Real> d = convert<Real>(D), a = convert<Real>(A), b = convert<Real>(B);
        REQUIRE(holds(all, side(d, a, b)));
        REQUIRE(holds(all, contracted_dot(d, cross(b, a))));
        // 11 bits more than a double has: of the true number it is off by far less than a double's rounding.
        REQUIRE(holds(all, side(convert<long double>(D), convert<long double>(A), convert<long double>(B))));

        const Ray<double> ray{A, D};
        const Sphere<double> sphere{B, std::abs(number()) + 1};
        const Number delta = discriminant(quadratic(convert<Number>(ray), convert<Number>(sphere)));
        REQUIRE(holds(delta, discriminant(quadratic(convert<Real>(ray), convert<Real>(sphere)))));
        REQUIRE(holds(delta, discriminant(quadratic(convert<long double>(ray), convert<long double>(sphere)))));
    }
}

TEST_CASE_TEMPLATE("what is exact in the scalar stays exact; what is not is off by a unit in the last place at most",
                   Real, float, double) {
    using Number = Enclosure<Real>;
    CHECK(is_exactly(Number(500.0) - Number(100.0), 400));
    CHECK(is_exactly(Number(0.5) * Number(3.0), 1.5));
    CHECK(is_exactly(Number(3.0) / Number(4.0), 0.75));
    CHECK(is_exactly(Number(0.0) / Number(3.0), 0));
    CHECK(is_exactly(sqrt(Number(6.25)), 2.5));
    CHECK(is_exactly(Number(0.1) * Number(0), 0));
    const double unit = static_cast<double>(std::numeric_limits<Real>::epsilon());
    const Number third = Number(1) / Number(3);
    CHECK(third.range().error >
          unit / 4);  // 1/3 is rounded: a unit in the last place of it is u/2, half of that a bound
    CHECK(third.range().error < unit);
    const Number sum = Number(1) + Number(unit / 4);  // needs more digits than there are
    CHECK(sum.range().error >= unit / 4);
    // 0.1 is a double, and no float.
    CHECK(is_exactly(Number(0.1), 0.1) == std::is_same_v<Real, double>);
}

TEST_CASE("too large for float, or too small: then nothing is known") {
    using Number = Enclosure<float>;
    CHECK_FALSE(isfinite(Number(1e39)));
    CHECK_FALSE(isfinite(Number(1e30) * Number(1e30)));
    const Number tiny = Number(1e-30) * Number(1e-30);  // a float has no such number: it becomes 0
    CHECK(holds(tiny, 0));
    CHECK(holds(tiny, 1e-60L));
    CHECK_FALSE(surely(tiny > Number(0)));
}

TEST_CASE("where a sign is open, shading holds what either way gives") {
    using Number = Enclosure<double>;
    const Number open(Bounded(0.25, 1));  // from −0.75 to 1.25
    for (const double x : {0.0, 0.5, 1.25}) CHECK(holds(positive_part(open), x));
    CHECK_FALSE(holds(positive_part(open), -0.01));
    CHECK(is_exactly(positive_part(Number(Bounded(-2, 1))), 0));
    CHECK(positive_part(Number(Bounded(2, 1))).range().value == 2);
    const Vec3<Number> n{Number(0), Number(0), Number(1)}, edge_on{Number(1), Number(0), open};
    for (const double z : {-1.0, 1.0}) CHECK(holds(towards(edge_on, n).z, z));
    CHECK(is_exactly(towards({Number(0), Number(0), Number(-1)}, n).z, -1));
}

TEST_CASE("a unit vector of an unknown direction still is one") {
    using Number = Enclosure<float>;
    // From −1 to 3 in x: its length may be 0.
    const Vec3<Number> v{Number(Bounded(1, 2)), Number(0), Number(0)};
    CHECK_FALSE(isfinite(unit(v).x));
    const Vec3<Number> n = within_unit(unit(v));
    for (const double x : {-1.0, 0.5, 1.0}) CHECK(holds(n.x, x));
    CHECK_FALSE(holds(n.x, 1.1));
    CHECK(is_exactly(within_unit(Vec3<Number>{Number(0.5), Number(0), Number(1)}).x, 0.5));
}

TEST_CASE("powers lie between those of the ends") {
    using Number = Enclosure<double>;
    const Number power = pow(Number(Bounded(0.5, 0.25)), Number(2));  // 1/16 to 9/16
    for (const double x : {0.0625, 0.25, 0.5625}) CHECK(holds(power, x));
    CHECK_FALSE(holds(power, 0.57));
}
