#pragma once
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace glassbox::test {

/// Doubles of all kinds, the same ones on every machine: zeros, subnormals, powers of two and their neighbours, few
/// bits and many, over all exponents or near 0.
class Doubles {
public:
    explicit Doubles(std::uint64_t seed) : bits_(seed) {}

    std::uint64_t below(std::uint64_t n) { return bits_() % n; }
    bool one_in(std::uint64_t n) { return below(n) == 0; }
    /// In [0, 1).
    double fraction() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
    double sign() { return one_in(2) ? 1 : -1; }

    /// In [1, 2).
    double mantissa() {
        switch (below(6)) {
            case 0:
                return 1;
            case 1:
                return 1 + 0x1p-52;
            case 2:
                return 2 - 0x1p-52;
            case 3:
                return 1 + std::ldexp(static_cast<double>(below(16)), -4);
            default:
                return 1 + fraction();
        }
    }

    /// Positive, with an exponent from `least` to `most`.
    double positive(int least, int most) {
        return std::ldexp(mantissa(), least + static_cast<int>(below(static_cast<std::uint64_t>(most - least + 1))));
    }

    /// Any finite number.
    double any() {
        if (one_in(20)) return 0;
        if (one_in(20)) return sign() * positive(-1074, -1018);
        if (one_in(20)) return sign() * positive(1020, 1023);
        return sign() * (one_in(2) ? positive(-30, 30) : positive(-1074, 1023));
    }

private:
    std::mt19937_64 bits_;
};

}  // namespace glassbox::test
