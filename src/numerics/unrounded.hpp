#pragma once
#include <bit>
#include <cmath>
#include <cstdint>

#include "numerics/two_sum.hpp"

namespace glassbox {

/// A double that knows whether anything was rounded on the way to it. Where nothing was, a formula's sign is exact, at
/// a few times the cost of double: so is often the case where coordinates have few digits, as on grids, and it is just
/// there that numbers are exactly 0.
class Unrounded {
public:
    Unrounded() = default;
    explicit Unrounded(double value) : value_(value) {}

    double value() const { return value_; }
    bool is_exact() const { return is_exact_; }

    friend Unrounded operator-(const Unrounded& a) { return {-a.value_, a.is_exact_}; }

    friend Unrounded operator+(const Unrounded& a, const Unrounded& b) {
        const double sum = a.value_ + b.value_;
        return {sum, a.is_exact_ && b.is_exact_ && lost_in_sum(a.value_, b.value_, sum) == 0};
    }
    friend Unrounded operator-(const Unrounded& a, const Unrounded& b) { return a + -b; }

    /// A product has as many digits as its factors together at most: 53 fit. It must not be subnormal.
    friend Unrounded operator*(const Unrounded& a, const Unrounded& b) {
        const double product = a.value_ * b.value_;
        const bool fits = product == 0 ? a.value_ == 0 || b.value_ == 0
                                       : digits(a.value_) + digits(b.value_) <= 53 && std::isnormal(product);
        return {product, a.is_exact_ && b.is_exact_ && fits};
    }

private:
    Unrounded(double value, bool is_exact) : value_(value), is_exact_(is_exact) {}

    /// Binary digits from the first that is 1 to the last: 53 or less.
    static int digits(double x) {
        constexpr std::uint64_t leading = std::uint64_t{1} << 52;
        return 53 - std::countr_zero((std::bit_cast<std::uint64_t>(x) & (leading - 1)) | leading);
    }

    double value_ = 0;
    bool is_exact_ = true;
};

}  // namespace glassbox
