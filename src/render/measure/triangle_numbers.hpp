#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include <magnitude.hpp>
#include <tolerance.hpp>

#include "render/measure/channel.hpp"
#include "render/measure/of_sides.hpp"

namespace glassbox {

/// The three side products of a triangle as a scalar computed them, with the sizes of their terms and their error
/// bounds. All are divided by one power of two, so that a double holds them for any scalar and any size of scene.
///
/// Rounding moves a side product by less than 8u times the sum of its terms' sizes (see filter.hpp). A product that
/// underflows is off by η/2 more, η the scalar's least positive number: two products in each component of a cross
/// product, which D then multiplies, and three after that, together less than η(2 + |Dx| + |Dy| + |Dz|).
template <class Real>
class ScaledSides {
public:
    ScaledSides(const Vec3<Real>& D, const Triangle<Real>& seen)
        : length_(std::max({exponent(seen.A), exponent(seen.B), exponent(seen.C), tiny / 3})), direction_(exponent(D)) {
        const Vec3<double> d = scaled(D, direction_);
        const Triangle<double> triangle{scaled(seen.A, length_), scaled(seen.B, length_), scaled(seen.C, length_)};
        const Sides<Magnitude> S = glassbox::sides(convert<Magnitude>(d), convert<Magnitude>(triangle));
        sizes = {S.a.size, S.b.size, S.c.size};
        values = glassbox::sides(D, seen);
        sides = {scaled(values.a), scaled(values.b), scaled(values.c)};
        along_ = (std::abs(d.x) + std::abs(d.y) + std::abs(d.z)) * (1 + 0x1p-16);  // rounded, too
        is_tiny = length_ < 0 || direction_ < 0;
    }

    Sides<Real> values;  ///< not scaled
    Sides<double> sides, sizes;
    bool is_tiny;  ///< the largest numbers are below 2^-60: what is computed of the side products may underflow

    Sides<double> bounds() const {
        const double underflow = std::ldexp(1.0, tiny - 2 * length_) * along_ + std::ldexp(2.0, tiny - length());
        return {bound(sizes.a, underflow), bound(sizes.b, underflow), bound(sizes.c, underflow)};
    }

    /// Another number in length² |D|.
    double scaled(Real number) const { return scaled(number, length()); }

private:
    using Wide = std::common_type_t<Real, double>;

    static constexpr double u = static_cast<double>(std::numeric_limits<Real>::epsilon()) / 2;
    /// η is 2 to this power.
    static constexpr int tiny = std::numeric_limits<Real>::min_exponent - std::numeric_limits<Real>::digits;

    int length() const { return 2 * length_ + direction_; }

    /// The exponent of the largest component; 0 if that has an ordinary size, and nothing needs to be scaled.
    static int exponent(const Vec3<Real>& v) {
        const Real largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
        if (largest > Real(0x1p-60f) && largest < Real(0x1p60f)) return 0;
        int result = std::numeric_limits<Real>::min_exponent;
        if (largest > 0 && std::isfinite(largest)) std::frexp(largest, &result);
        return result;
    }
    static double scaled(Real number, int by) {
        return static_cast<double>(by == 0 ? number : std::ldexp(static_cast<Wide>(number), -by));
    }
    static Vec3<double> scaled(const Vec3<Real>& v, int by) {
        return {scaled(v.x, by), scaled(v.y, by), scaled(v.z, by)};
    }

    /// The bound is itself rounded, and may itself underflow.
    static double bound(double size, double underflow) {
        return (8 * u * size + underflow) * (1 + 0x1p-40) + 8 * std::numeric_limits<double>::denorm_min();
    }

    /// Exponents of the largest coordinate, but not below that of η's cube root, and of D's largest component.
    int length_, direction_;
    double along_;  ///< no less than |D.x| + |D.y| + |D.z|
};

/// Measures the side products of all triangles tested at a pixel; `no_value` before the first triangle, and where a
/// number is too large for the scalar.
struct TriangleNumbers {
    double side = no_value;      ///< the smallest side product, over the sum of its terms' sizes
    double margin = no_value;    ///< log10 of the deciding sign's |s| over its bound, for the least certain triangle
    double deficit = no_value;   ///< log10 of the paper's difference, the smallest
    double identity = no_value;  ///< the largest |a+b+c + D·((B−A)×(C−A))|, over an eighth of their bounds
    bool tested = false;         ///< at least one triangle was tested
    /// The triangles whose deciding side product came out as 0, as seen from the ray's start.
    std::vector<Triangle<long double>> zeros = {};
    double margin_of_others = no_value;  ///< the margin of all products but these zeros
    OfSides asked = OfSides::all;        ///< the numbers that are not asked for are left without a value

    /// Adds one triangle as seen from the ray's start, and the ray's direction.
    template <class Real>
    void take(const Triangle<Real>& seen, const Vec3<Real>& D) {
        tested = true;
        const ScaledSides<Real> s(D, seen);
        if (asked != OfSides::least_certain) {
            take_side(s.values.a, s.sides.a, s.sizes.a);
            take_side(s.values.b, s.sides.b, s.sizes.b);
            take_side(s.values.c, s.sides.c, s.sizes.c);
        }
        if (asked == OfSides::least) return;
        const Sides<double> bounds = s.bounds();
        take_certainty(certainty(s.sides, bounds), s, bounds, seen);
        if (asked == OfSides::least_certain) return;
        keep(deficit, log10_of_deficit(seen, D), std::fmin);
        keep(identity, residual(seen, D, s, bounds), std::fmax);
    }

    /// Takes the zeros for what they are: exactly 0. No error is there to be near to: their own margin is ∞.
    void know_zeros() { margin = margin_of_others < 0 ? margin_of_others : std::numeric_limits<double>::infinity(); }

private:
    long double smallest_side_ = std::numeric_limits<long double>::infinity();

    static void keep(double& kept, double value, double (*better)(double, double)) { kept = better(kept, value); }

    template <class Real>
    void take_certainty(double certainty, const ScaledSides<Real>& s, const Sides<double>& bounds,
                        const Triangle<Real>& seen) {
        const bool is_zero = certainty == 0 && !s.is_tiny && std::isfinite(bounds.a + bounds.b + bounds.c) &&
                             std::isfinite(s.sides.a + s.sides.b + s.sides.c);
        if (is_zero) zeros.push_back(convert<long double>(seen));
        keep(margin_of_others, std::log10(is_zero ? certainty_of_nonzero(s.sides, bounds) : certainty), std::fmin);
        keep(margin, std::log10(certainty), std::fmin);
    }

    void take_side(long double s, double scaled, double size) {
        if (!(std::abs(s) < smallest_side_) || !std::isfinite(size)) return;
        smallest_side_ = std::abs(s);
        side = size > 0 ? scaled / size : 0;
    }

    /// |s| over its bound, for the deciding sign: for a hit, the least certain of the three; for a miss, the less
    /// certain of the most surely positive and the most surely negative one.
    static double certainty(const Sides<double>& s, const Sides<double>& bounds) {
        const auto over_bound = [](double value, double bound) {
            return std::isfinite(value) && std::isfinite(bound) ? value / bound : 0.0;
        };
        const double a = over_bound(s.a, bounds.a), b = over_bound(s.b, bounds.b), c = over_bound(s.c, bounds.c);
        const double least = std::min({a, b, c}), greatest = std::max({a, b, c});
        if (least < 0 && greatest > 0) return std::min(-least, greatest);
        return std::min({std::abs(a), std::abs(b), std::abs(c)});
    }

    /// The least certain of those that did not come out as 0; ∞ if all did.
    static double certainty_of_nonzero(const Sides<double>& s, const Sides<double>& bounds) {
        const auto sure = [](double value, double bound) {
            return value == 0 ? std::numeric_limits<double>::infinity() : std::abs(value) / bound;
        };
        return std::min({sure(s.a, bounds.a), sure(s.b, bounds.b), sure(s.c, bounds.c)});
    }

    /// The deficit as the tolerance rule itself reports it.
    template <class Real>
    static double log10_of_deficit(const Triangle<Real>& seen, const Vec3<Real>& D) {
        Real told_deficit = 0;
        const auto listen = [&]<class What, class... Values>(What, const Values&... values) {
            if constexpr (std::is_same_v<What, told::Deficit>) ((told_deficit = values), ...);
        };
        Tolerance{}(Ray<Real>{{}, D}, seen, listen);
        return static_cast<double>(std::log10(told_deficit));
    }

    template <class Real>
    static double residual(const Triangle<Real>& seen, const Vec3<Real>& D, const ScaledSides<Real>& s,
                           const Sides<double>& bounds) {
        const auto& [A, B, C] = seen;
        const double difference = s.scaled(s.values.a + s.values.b + s.values.c + dot(D, cross(B - A, C - A)));
        const double unit = (bounds.a + bounds.b + bounds.c) / 8;
        return std::isfinite(unit) ? std::abs(difference) / unit : no_value;
    }
};

}  // namespace glassbox
