#pragma once
#include <bit>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

namespace glassbox {

/// An integer times a power of two: the exact value of every finite double. Sums, differences and products are exact.
class Dyadic {
public:
    using Integer = boost::multiprecision::number<
        boost::multiprecision::cpp_int_backend<512, 0, boost::multiprecision::signed_magnitude,
                                               boost::multiprecision::unchecked,
                                               std::allocator<boost::multiprecision::limb_type>>,
        boost::multiprecision::et_off>;
    /// A binary float so long that its own rounding is negligible beside a rounding to double.
    static constexpr int long_bits = 320;
    using Long = boost::multiprecision::number<
        boost::multiprecision::cpp_bin_float<long_bits, boost::multiprecision::digit_base_2, void, std::int64_t>,
        boost::multiprecision::et_off>;

    Dyadic() = default;

    /// `value` must be finite.
    explicit Dyadic(double value) {
        if (value == 0) return;
        int exponent = 0;
        auto whole = static_cast<long long>(std::ldexp(std::frexp(value, &exponent), 53));
        const int zeros = std::countr_zero(static_cast<unsigned long long>(whole));
        mantissa_ = whole / (1LL << zeros);
        exponent_ = exponent - 53 + zeros;
    }

    /// Converts a long double, which may have more bits than a double or lie beyond its range. It must be finite.
    static Dyadic from(long double value) {
        int exponent = 0;
        long double rest = std::frexp(value, &exponent);
        Dyadic result;
        while (rest != 0) {
            const auto head = static_cast<double>(rest);
            result = result + Dyadic(head);
            rest -= static_cast<long double>(head);
        }
        if (result.sign() != 0) result.exponent_ += exponent;
        return result;
    }

    int sign() const { return mantissa_.sign(); }

    friend Dyadic operator-(Dyadic a) {
        a.mantissa_ = -a.mantissa_;
        return a;
    }
    friend Dyadic operator+(const Dyadic& a, const Dyadic& b) {
        if (a.sign() == 0) return b;
        if (b.sign() == 0) return a;
        if (a.exponent_ == b.exponent_) return {a.mantissa_ + b.mantissa_, a.exponent_};
        if (a.exponent_ < b.exponent_) return b + a;
        return {Integer(a.mantissa_ << static_cast<unsigned long>(a.exponent_ - b.exponent_)) + b.mantissa_,
                b.exponent_};
    }
    friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }
    friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
        return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
    }
    /// Whether mantissa and exponent are the same. Those of equal numbers may differ: 2·2⁰ and 1·2¹.
    friend bool is_written_alike(const Dyadic& a, const Dyadic& b) {
        return a.exponent_ == b.exponent_ && a.mantissa_ == b.mantissa_;
    }

    /// The nearest long float, within 2⁻³²⁰ of it.
    Long to_long() const { return ldexp(Long(mantissa_), exponent_); }

private:
    Dyadic(Integer mantissa, long exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {
        if (mantissa_.is_zero()) exponent_ = 0;
    }

    Integer mantissa_ = 0;
    long exponent_ = 0;
};

}  // namespace glassbox
