#pragma once
#include <cmath>
#include <limits>
#include <utility>

#include "numerics/bounded.hpp"
#include "numerics/dyadic.hpp"

namespace glassbox {

/// A number without any rounding: (p + q√d) / r with dyadic p, q, d ≥ 0 and r > 0. That is all that a ray and a sphere
/// can bring forth: rationals, and one square root at a time, whose signs can be found by squaring.
///
/// Sums, products and quotients take operands with the same root, or with none; comparisons take any, and decide all.
class Exact {
public:
    Exact() = default;
    /// `value` must be finite.
    explicit Exact(double value) : p_(value) {}

    int sign() const { return sign_of(p_, q_, d_); }

    friend Exact operator-(Exact a) {
        a.p_ = -a.p_;
        a.q_ = -a.q_;
        return a;
    }
    friend Exact operator+(const Exact& a, const Exact& b) {
        if (is_written_alike(a.r_, b.r_)) return {a.p_ + b.p_, a.q_ + b.q_, root_of(a, b), a.r_};
        return {a.p_ * b.r_ + b.p_ * a.r_, a.q_ * b.r_ + b.q_ * a.r_, root_of(a, b), a.r_ * b.r_};
    }
    friend Exact operator-(const Exact& a, const Exact& b) { return a + -b; }
    friend Exact operator*(const Exact& a, const Exact& b) {
        if (a.is_rational() && b.is_rational()) return {a.p_ * b.p_, {}, {}, a.r_ * b.r_};
        const Dyadic& d = root_of(a, b);
        return {a.p_ * b.p_ + a.q_ * b.q_ * d, a.p_ * b.q_ + a.q_ * b.p_, d, a.r_ * b.r_};
    }
    /// b must not be 0. (p + q√d)(p − q√d) = p² − q²d clears the root from the denominator; where that is 0, q√d is p.
    friend Exact operator/(const Exact& a, const Exact& b) {
        const Dyadic norm = b.p_ * b.p_ - b.q_ * b.q_ * b.d_;
        const bool doubled = norm.sign() == 0;
        const Dyadic n = doubled ? b.p_ + b.p_ : norm;
        const Dyadic positive = n.sign() < 0 ? -n : n;
        const Exact quotient =
            a * (doubled ? Exact(b.r_, {}, {}, positive) : Exact(b.p_ * b.r_, -(b.q_ * b.r_), b.d_, positive));
        return n.sign() < 0 ? -quotient : quotient;
    }
    /// a must be 0 or more, and without a root: √(p/r) = √(pr) / r.
    friend Exact sqrt(const Exact& a) { return {Dyadic(), Dyadic(1), a.p_ * a.r_, a.r_}; }
    friend Exact abs(const Exact& a) { return a.sign() < 0 ? -a : a; }

    friend Kleene operator<(const Exact& a, const Exact& b) { return compare(a, b) < 0; }
    friend Kleene operator>(const Exact& a, const Exact& b) { return compare(a, b) > 0; }
    friend Kleene operator<=(const Exact& a, const Exact& b) { return compare(a, b) <= 0; }
    friend Kleene operator>=(const Exact& a, const Exact& b) { return compare(a, b) >= 0; }
    friend Kleene operator==(const Exact& a, const Exact& b) { return compare(a, b) == 0; }
    friend Kleene operator!=(const Exact& a, const Exact& b) { return compare(a, b) != 0; }

    /// -1, 0 or 1 as a is less than, equal to or greater than b; each may have a root of its own.
    friend int compare(const Exact& a, const Exact& b) {
        if (b.p_.sign() == 0 && b.is_rational()) return a.sign();
        const Dyadic A = a.p_ * b.r_ - b.p_ * a.r_, B = a.q_ * b.r_, C = -(b.q_ * a.r_);
        // The sign of (A + B√d) + C√e: if the two parts disagree, the one with the greater square wins.
        const int first = sign_of(A, B, a.d_);
        const int second = b.d_.sign() == 0 ? 0 : C.sign();
        if (first == 0 || second == 0 || first == second) return first != 0 ? first : second;
        const Dyadic two(2);
        return first * sign_of(A * A + B * B * a.d_ - C * C * b.d_, two * A * B, a.d_);
    }

    /// The number as a long float, within a few units of its last place: where p and q√d would cancel,
    /// (p² − q²d) / (p − q√d) is taken instead.
    Dyadic::Long to_long() const {
        const Dyadic::Long p = p_.to_long(), r = r_.to_long();
        if (is_rational()) return p / r;
        const Dyadic::Long root = q_.to_long() * sqrt(d_.to_long());
        if (p_.sign() * q_.sign() >= 0) return (p + root) / r;
        return (p_ * p_ - q_ * q_ * d_).to_long() / ((p - root) * r);
    }

    /// The nearest double, and a bound on how far it is: nearly all of it is that double's own rounding.
    Bounded to_bounded() const {
        const Dyadic::Long exact = to_long();
        const auto nearest = static_cast<double>(exact);
        if (!std::isfinite(nearest)) return {nearest, std::numeric_limits<double>::infinity()};
        if (compare(*this, Exact(nearest)) == 0) return Bounded(nearest);
        const auto distance = static_cast<double>(abs(exact - nearest));
        const auto slack = static_cast<double>(ldexp(abs(exact), -300));
        const double error = Bounded::up(distance + slack);
        if (error > 0x1p-960 || sign() == 0) return {nearest, error};
        return {nearest, error + Bounded::underflow};  // the distance itself may have lost bits to underflow
    }

private:
    Exact(Dyadic p, Dyadic q, Dyadic d, Dyadic r)
        : p_(std::move(p)), q_(std::move(q)), d_(std::move(d)), r_(std::move(r)) {
        if (q_.sign() == 0 || d_.sign() == 0) q_ = d_ = Dyadic();
    }

    bool is_rational() const { return q_.sign() == 0; }

    static const Dyadic& root_of(const Exact& a, const Exact& b) { return a.is_rational() ? b.d_ : a.d_; }

    /// Of p + q√d.
    static int sign_of(const Dyadic& p, const Dyadic& q, const Dyadic& d) {
        const int first = p.sign(), second = d.sign() == 0 ? 0 : q.sign();
        if (first == 0 || second == 0 || first == second) return first != 0 ? first : second;
        return first * (p * p - q * q * d).sign();
    }

    Dyadic p_, q_, d_, r_ = Dyadic(1);
};

}  // namespace glassbox
