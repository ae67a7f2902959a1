#pragma once
#include <doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <ostream>

#include <support/random_bits.hpp>
#include <support/traced_ray.hpp>
#include <support/ulps.hpp>
#include <vec3.hpp>

/// What the stages' tests share: sizes to try, random numbers, and checks of whole vectors.
namespace glassbox {

template <class Real>
std::ostream& operator<<(std::ostream& out, const Vec3<Real>& a) {
    return out << std::setprecision(std::numeric_limits<Real>::max_digits10) << '(' << a.x << ", " << a.y << ", " << a.z
               << ')';
}

}  // namespace glassbox

namespace glassbox::test {

/// The distance from 1 to the next number: twice the largest relative error of one operation.
template <class Real>
constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

/// Sizes from 1e-10 to 1e10, 1 first: what fails is told with the first size that fails. Powers of two, as multiplying
/// by those rounds nothing: what holds at size 1 to the bit must hold at each of these to the bit.
template <class Real>
constexpr std::array<Real, 5> sizes{Real(1), Real(0x1p13), Real(0x1p-13), Real(0x1p33), Real(0x1p-33)};

/// Random numbers, the same ones on every machine. The first ones are few digits long, for whoever must read with what
/// a test fails.
class Dice {
public:
    template <class Real>
    Real between(Real low, Real high) {
        const std::uint64_t bits = random_.next();
        if (short_ones_ > 0) {  // an odd number of 16ths of the way: no end, no middle
            --short_ones_;
            return low + (high - low) * (static_cast<Real>(bits >> 61 << 1 | 1) / 16);
        }
        return low + (high - low) * (static_cast<Real>(bits >> 11) * Real(0x1p-53));
    }

    template <class Real>
    Vec3<Real> vector(Real size) {
        const Real x = between(-size, size), y = between(-size, size), z = between(-size, size);
        return {x, y, z};
    }

    int whole(int low, int high) {
        return low + static_cast<int>(random_.next() % static_cast<std::uint64_t>(high - low + 1));
    }

    template <class Real>
    Vec3<Real> whole_vector(int size) {
        const int x = whole(-size, size), y = whole(-size, size), z = whole(-size, size);
        return {static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(z)};
    }

private:
    RandomBits random_;
    int short_ones_ = 60;
};

/// |a|, for bounds and weights in tests: without the learner's own `length`.
template <class Real>
Real size_of(const Vec3<Real>& a) {
    return std::hypot(a.x, a.y, a.z);
}

template <class Real>
void check_ulps(const Vec3<Real>& got, const Vec3<Real>& expected, double most, const char* expression,
                const char* file, int line) {
    const auto three = [](const Vec3<Real>& a) { return std::array<Real, 3>{a.x, a.y, a.z}; };
    check_ulps(three(got), three(expected), most, expression, file, line);
}

}  // namespace glassbox::test

/// Fails, with expected, got and ulps, if the two are further apart than `most`, an absolute number.
#define CHECK_WITHIN(got, expected, most) \
    glassbox::test::check_within((got), (expected), (most), #got, __FILE__, __LINE__)

/// Equal in every bit, but for the sign of zero.
#define CHECK_EXACT(got, expected) CHECK_ULPS(got, expected, 0)

/// Records which ray is traced now against which surface, a sphere or a triangle: if a check fails, that is what to
/// look at.
#define CAPTURE_RAY(ray, surface) glassbox::test::trace((ray), (surface))

/// The scalars that every property is checked for. `glassbox learn` runs one after the other, to answer sooner.
#ifndef EVERY_SCALAR
#define EVERY_SCALAR float, double, long double
#endif
