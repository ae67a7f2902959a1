#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include <triangle.hpp>

#include "numerics/magnitude.hpp"
#include "render/plane.hpp"

namespace glassbox {

/// What the side products of all triangles tested at a pixel say about themselves; `no_value` before the first.
struct TriangleNumbers {
    double side = no_value;      ///< the smallest side product, over the sum of its terms' sizes
    double margin = no_value;    ///< log10 of the deciding sign's |s| over its bound, for the least certain triangle
    double deficit = no_value;   ///< log10 of the paper's difference, the smallest
    double identity = no_value;  ///< the largest |a+b+c + D·((B−A)×(C−A))|, in units of u times its terms' sizes

    /// Takes in one triangle as seen from the ray's start, and the ray's direction.
    template <class Real>
    void take(const Triangle<Real>& seen, const Vec3<Real>& D) {
        const Sides<Real> s = sides(D, seen);
        const Sides<Magnitude> S = sides(convert<Magnitude>(D), convert<Magnitude>(seen));
        take_side(static_cast<double>(s.a), S.a.size);
        take_side(static_cast<double>(s.b), S.b.size);
        take_side(static_cast<double>(s.c), S.c.size);
        keep(margin, std::log10(certainty(s, S)), std::fmin);
        keep(deficit, std::log10(deficit_of(seen, D)), std::fmin);
        keep(identity, residual(seen, D, s, S), std::fmax);
    }

private:
    double smallest_side_ = std::numeric_limits<double>::infinity();

    template <class Real>
    static constexpr double u = static_cast<double>(std::numeric_limits<Real>::epsilon()) / 2;

    static void keep(double& kept, double value, double (*better)(double, double)) { kept = better(kept, value); }

    void take_side(double s, double size) {
        if (!(std::abs(s) < smallest_side_)) return;
        smallest_side_ = std::abs(s);
        side = size > 0 ? s / size : 0;
    }

    /// |s| over its bound 8uS, of the sign that decides: of a hit, the least certain of the three; of a miss, the less
    /// certain of one that is surely positive and one that is surely negative.
    template <class Real>
    static double certainty(const Sides<Real>& s, const Sides<Magnitude>& S) {
        const auto over_bound = [](Real value, double size) {
            return size > 0 ? static_cast<double>(value) / (8 * u<Real> * size) : 0.0;
        };
        const double a = over_bound(s.a, S.a.size), b = over_bound(s.b, S.b.size), c = over_bound(s.c, S.c.size);
        const double least = std::min({a, b, c}), greatest = std::max({a, b, c});
        if (least < 0 && greatest > 0) return std::min(-least, greatest);
        return std::min({std::abs(a), std::abs(b), std::abs(c)});
    }

    /// As the tolerance rule itself tells it.
    template <class Real>
    static double deficit_of(const Triangle<Real>& seen, const Vec3<Real>& D) {
        double told_deficit = no_value;
        const auto listen = [&]<class What, class... Values>(What, const Values&... values) {
            if constexpr (std::is_same_v<What, told::Deficit>) ((told_deficit = static_cast<double>(values)), ...);
        };
        Tolerance{}(Ray<Real>{{}, D}, seen, listen);
        return told_deficit;
    }

    template <class Real>
    static double residual(const Triangle<Real>& seen, const Vec3<Real>& D, const Sides<Real>& s,
                           const Sides<Magnitude>& S) {
        const auto& [A, B, C] = seen;
        const Real difference = s.a + s.b + s.c + dot(D, cross(B - A, C - A));
        const double size = u<Real> * (S.a + S.b + S.c).size;
        return size > 0 ? std::abs(static_cast<double>(difference)) / size : 0;
    }
};

}  // namespace glassbox
