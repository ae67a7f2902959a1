#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <random>

namespace glassbox::fuzz {

/// Numbers drawn at random, the same ones on every machine.
class Random {
public:
    explicit Random(std::uint64_t seed) : bits_(seed * 0x9E3779B97F4A7C15u + 1) {}

    std::uint64_t below(std::uint64_t n) { return bits_() % n; }
    bool one_in(std::uint64_t n) { return below(n) == 0; }
    /// In [0, 1).
    double fraction() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
    double sign() { return one_in(2) ? 1 : -1; }
    int between(int least, int most) {
        return least + static_cast<int>(below(static_cast<std::uint64_t>(most - least) + 1));
    }
    double power_of_two(int least, int most) { return std::ldexp(1, between(least, most)); }
    /// A whole number of so many bits, or its negative.
    double few_bits(int bits) { return between(-(1 << bits), 1 << bits); }
    template <class Value>
    Value of(std::initializer_list<Value> values) {
        return values.begin()[below(values.size())];
    }
    template <class List>
    const auto& of_list(const List& values) {
        return values[below(values.size())];
    }

private:
    std::mt19937_64 bits_;
};

}  // namespace glassbox::fuzz
