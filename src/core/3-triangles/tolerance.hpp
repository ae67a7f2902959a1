#pragma once
#include <cmath>

#include <intersect_triangle.hpp>

namespace glassbox {

namespace told {
struct Deficit {};  ///< (a+b+c, | |a+b+c| − (|a|+|b|+|c|) |): the sum of the sides, and how far their signs disagree
}  // namespace told

/// The rule of the paper's program, kept as history: it accepts where | |a+b+c| − (|a|+|b|+|c|) | is below an absolute
/// tolerance. That difference is twice the smaller of the positive and the negative part of the sum, in units of
/// length² |D|: a small triangle accepts nearly every ray, and a large one rejects true hits because of rounding alone.
struct Tolerance {
    double tolerance = 10.0;

    constexpr bool operator==(const Tolerance&) const = default;

    template <class Real, class Probe>
    constexpr Crossing<Real> operator()(const Ray<Real>& ray, const Triangle<Real>& triangle, Probe& probe) const {
        const auto is_inside = [this](const Sides<Real>& s, Probe& told_to) { return accepts(*this, s, told_to); };
        return by_sides(ray, triangle, is_inside, probe);
    }
};

/// Whether the rule takes a line with these side products for one that passes through the triangle.
template <class Real, class Probe>
constexpr Truth<Real> accepts(const Tolerance& rule, const Sides<Real>& s, Probe& probe) {
    using std::abs;
    const Real sum = s.a + s.b + s.c;
    const Real deficit = abs(abs(sum) - (abs(s.a) + abs(s.b) + abs(s.c)));
    probe(told::Deficit{}, sum, deficit);
    return sum != Real(0) && deficit < static_cast<Real>(rule.tolerance);
}

}  // namespace glassbox
