#pragma once
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <bounded.hpp>

#include "numerics/dyadic.hpp"

namespace glassbox {

/// An exact number (p + q√d) / r with dyadic p, q, d ≥ 0 and r > 0. A ray and a sphere need no more: rationals and one
/// square root at a time, whose signs can be found by squaring.
///
/// Sums, products and quotients take operands with the same root, or with none; comparisons take any operands and
/// always decide.
class Exact {
public:
    Exact() = default;
    /// `value` must be finite.
    explicit Exact(double value) : p_(value) {}
    static Exact from(long double value) { return {Dyadic::from(value), {}, {}}; }

    int sign() const { return root_ ? sign_of(p_, root_->q, root_->d) : p_.sign(); }

    friend Exact operator-(Exact a) {
        a.p_ = -std::move(a.p_);
        if (a.root_) a.root_->q = -std::move(a.root_->q);
        return a;
    }
    friend Exact operator+(const Exact& a, const Exact& b) {
        if (is_same(a.r_, b.r_)) return {a.p_ + b.p_, sum(a.root_, b.root_), a.r_};
        return {times(a.p_, b.r_) + times(b.p_, a.r_), sum(times(a.root_, b.r_), times(b.root_, a.r_)),
                product(a.r_, b.r_)};
    }
    friend Exact operator-(const Exact& a, const Exact& b) { return a + -b; }
    friend Exact operator*(const Exact& a, const Exact& b) {
        if (a.root_ && b.root_) {
            const auto& [q, d] = *a.root_;
            return {a.p_ * b.p_ + q * b.root_->q * d, Root{a.p_ * b.root_->q + q * b.p_, d}, product(a.r_, b.r_)};
        }
        return {a.p_ * b.p_, a.root_ ? times(a.root_, b.p_) : times(b.root_, a.p_), product(a.r_, b.r_)};
    }
    /// b must not be 0. (p + q√d)(p − q√d) = p² − q²d clears the root from the denominator; where that is 0, q√d is p.
    friend Exact operator/(const Exact& a, const Exact& b) {
        Dyadic n = b.p_;
        Exact turned(times(Dyadic(1), b.r_), {}, {});  // the factor for a: a/b = a turned / n
        if (b.root_) {
            const auto& [q, d] = *b.root_;
            n = b.p_ * b.p_ - q * q * d;
            if (n.sign() == 0) n = b.p_ + b.p_;
            else turned = {times(b.p_, b.r_), Root{-times(q, b.r_), d}, {}};
        }
        const bool negative = n.sign() < 0;
        turned.r_ = negative ? -n : n;
        const Exact quotient = a * turned;
        return negative ? -quotient : quotient;
    }
    /// a must be 0 or more, and without a root: √(p/r) = √(pr) / r.
    friend Exact sqrt(const Exact& a) { return {Dyadic(), Root{Dyadic(1), times(a.p_, a.r_)}, a.r_}; }
    friend Exact abs(const Exact& a) { return a.sign() < 0 ? -a : a; }

    friend Kleene operator<(const Exact& a, const Exact& b) { return compare(a, b) < 0; }
    friend Kleene operator>(const Exact& a, const Exact& b) { return compare(a, b) > 0; }
    friend Kleene operator<=(const Exact& a, const Exact& b) { return compare(a, b) <= 0; }
    friend Kleene operator>=(const Exact& a, const Exact& b) { return compare(a, b) >= 0; }
    friend Kleene operator==(const Exact& a, const Exact& b) { return compare(a, b) == 0; }
    friend Kleene operator!=(const Exact& a, const Exact& b) { return compare(a, b) != 0; }

    /// -1, 0 or 1 as a is less than, equal to or greater than b; each may have a root of its own.
    friend int compare(const Exact& a, const Exact& b) {
        if (b.p_.sign() == 0 && !b.root_) return a.sign();
        const Dyadic A = times(a.p_, b.r_) - times(b.p_, a.r_);
        if (!a.root_ && !b.root_) return A.sign();
        const auto [B, d] = times(a.root_, b.r_).value_or(Root{});
        const auto [C, e] = times(b.root_, a.r_).value_or(Root{});
        // The sign of (A + B√d) − C√e: if the two parts have opposite signs, the one with the greater square decides.
        const int first = sign_of(A, B, d), second = -C.sign();
        if (first == 0 || second == 0 || first == second) return first != 0 ? first : second;
        const Dyadic two(2);
        return first * sign_of(A * A + B * B * d - C * C * e, two * A * B, d);
    }

    /// The number as a long float, within a few units of its last place. Where p and q√d would cancel, computes
    /// (p² − q²d) / (p − q√d) instead.
    Dyadic::Long to_long() const {
        const Dyadic::Long p = p_.to_long(), r = r_ ? r_->to_long() : Dyadic::Long(1);
        if (!root_) return p / r;
        const auto& [q, d] = *root_;
        const Dyadic::Long root = q.to_long() * sqrt(d.to_long());
        if (p_.sign() * q.sign() >= 0) return (p + root) / r;
        return (p_ * p_ - q * q * d).to_long() / ((p - root) * r);
    }

    /// The nearest double with a bound on its error, nearly all of which is that double's own rounding.
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
    /// q√d; neither q nor d is 0.
    struct Root {
        Dyadic q, d;
    };

    Exact(Dyadic p, std::optional<Root> root, std::optional<Dyadic> r)
        : p_(std::move(p)), root_(std::move(root)), r_(std::move(r)) {
        if (root_ && (root_->q.sign() == 0 || root_->d.sign() == 0)) root_.reset();
    }

    // A missing r is 1, and costs nothing.
    static Dyadic times(const Dyadic& x, const std::optional<Dyadic>& r) { return r ? x * *r : x; }
    static std::optional<Root> times(const std::optional<Root>& root, const Dyadic& factor) {
        if (!root) return {};
        return Root{root->q * factor, root->d};
    }
    static std::optional<Root> times(const std::optional<Root>& root, const std::optional<Dyadic>& r) {
        return r ? times(root, *r) : root;
    }
    static std::optional<Dyadic> product(const std::optional<Dyadic>& a, const std::optional<Dyadic>& b) {
        if (!a || !b) return a ? a : b;
        return *a * *b;
    }
    static bool is_same(const std::optional<Dyadic>& a, const std::optional<Dyadic>& b) {
        return a && b ? is_written_alike(*a, *b) : !a && !b;
    }
    /// The sum of two roots, with the same d if both are there.
    static std::optional<Root> sum(const std::optional<Root>& a, const std::optional<Root>& b) {
        if (!a || !b) return a ? a : b;
        return Root{a->q + b->q, a->d};
    }

    /// The sign of p + q√d.
    static int sign_of(const Dyadic& p, const Dyadic& q, const Dyadic& d) {
        const int first = p.sign(), second = d.sign() == 0 ? 0 : q.sign();
        if (first == 0 || second == 0 || first == second) return first != 0 ? first : second;
        return first * (p * p - q * q * d).sign();
    }

    Dyadic p_;
    std::optional<Root> root_;  ///< none: a rational number
    std::optional<Dyadic> r_;   ///< none: 1
};

}  // namespace glassbox
