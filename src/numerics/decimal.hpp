#pragma once
#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "numerics/dyadic.hpp"

namespace glassbox {

/// An integer times a power of ten: the exact value of every printed number and of every finite double. Sums, products
/// and comparisons are exact, so one can tell on which side of a double its printed form lies.
class Decimal {
public:
    using Integer = Dyadic::Integer;

    Decimal() = default;

    /// `value` must be finite. A fraction becomes m · 2⁻ᵏ = m 5ᵏ · 10⁻ᵏ.
    explicit Decimal(double value) {
        if (value == 0) return;
        int exponent = 0;
        auto whole = static_cast<long long>(std::ldexp(std::frexp(value, &exponent), 53));
        const int zeros = std::countr_zero(static_cast<unsigned long long>(whole));
        whole /= 1LL << zeros;
        exponent += zeros - 53;
        if (exponent >= 0) digits_ = Integer(whole) << static_cast<unsigned>(exponent);
        else digits_ = whole * pow(Integer(5), static_cast<unsigned>(-exponent));
        place_ = std::min(exponent, 0);
    }

    /// Reads a printed number: "-0.25", "3.1e-10".
    explicit Decimal(std::string_view printed) {
        const std::size_t e = printed.find_first_of("eE");
        if (e != std::string_view::npos) {
            const char* from = printed.data() + e + 1;
            std::from_chars(from + (*from == '+'), printed.data() + printed.size(), place_);
        }
        bool behind_point = false;
        for (const char c : printed.substr(0, e)) {
            if (c == '.') behind_point = true;
            if (c < '0' || c > '9') continue;
            digits_ = digits_ * 10 + (c - '0');
            place_ -= behind_point;
        }
        if (printed.starts_with('-')) digits_ = -digits_;
    }

    int sign() const { return digits_.sign(); }
    /// The place of the first digit that is not 0, a power of ten: 2 for 350, −1 for 0.35. 0 for 0.
    int first_place() const { return sign() == 0 ? 0 : place_ + static_cast<int>(abs(digits_).str().size()) - 1; }
    /// The place of the last digit that is not 0: 1 for 350, −2 for 0.35. 0 for 0.
    int last_place() const {
        const std::string text = digits_.str();
        const std::size_t last = text.find_last_not_of('0');
        return last == std::string::npos ? 0 : place_ + static_cast<int>(text.size() - 1 - last);
    }

    friend Decimal operator-(Decimal a) {
        a.digits_ = -a.digits_;
        return a;
    }
    friend Decimal operator+(const Decimal& a, const Decimal& b) {
        if (a.place_ < b.place_) return b + a;
        return {a.digits_ * power(a.place_ - b.place_) + b.digits_, b.place_};
    }
    friend Decimal operator-(const Decimal& a, const Decimal& b) { return a + -b; }
    friend Decimal operator*(const Decimal& a, const Decimal& b) {
        return {a.digits_ * b.digits_, a.place_ + b.place_};
    }
    friend Decimal abs(const Decimal& a) { return a.sign() < 0 ? -a : a; }
    friend bool operator<=(const Decimal& a, const Decimal& b) { return (a - b).sign() <= 0; }
    friend bool operator==(const Decimal& a, const Decimal& b) { return (a - b).sign() == 0; }

    static Decimal power_of_ten(int exponent) { return {Integer(1), exponent}; }

    /// The nearest multiple of 10 to the power of `place`.
    Decimal rounded(int place) const {
        if (place <= place_) return *this;
        const Integer unit = power(place - place_), half = unit / 2;
        const Integer size = (abs(digits_) + half) / unit;
        return {sign() < 0 ? Integer(-size) : size, place};
    }
    /// The least number with that many digits that is not below this one, which must be 0 or more.
    Decimal rounded_up(int digits) const {
        const int place = first_place() - digits + 1;
        if (place <= place_) return *this;
        const Integer unit = power(place - place_);
        return {(digits_ + unit - 1) / unit, place};
    }

    /// All its digits, as "%g" would write them: "0.25", "3.1e-10", "2.5e+11".
    std::string text() const {
        if (sign() == 0) return "0";
        std::string digits = abs(digits_).str();
        const int first = first_place(), last = last_place();
        digits.resize(static_cast<std::size_t>(first - last + 1));
        const std::string before = sign() < 0 ? "-" : "";
        const auto zeros = [](int count) { return std::string(static_cast<std::size_t>(count), '0'); };
        if (first < -4 || (last > 0 && first >= 6)) {
            if (digits.size() > 1) digits.insert(1, ".");
            const std::string exponent = std::to_string(std::abs(first));
            return before + digits + (first < 0 ? "e-" : "e+") + (exponent.size() < 2 ? "0" : "") + exponent;
        }
        if (last >= 0) return before + digits + zeros(last);
        if (first < 0) return before + "0." + zeros(-first - 1) + digits;
        return before + digits.insert(static_cast<std::size_t>(first + 1), ".");
    }

private:
    Decimal(Integer digits, int place) : digits_(std::move(digits)), place_(place) {}

    static Integer power(int exponent) { return pow(Integer(10), static_cast<unsigned>(exponent)); }

    Integer digits_ = 0;
    int place_ = 0;  ///< of the last digit
};

}  // namespace glassbox
