#pragma once
#include <cstdint>

namespace glassbox {

/// Random numbers, the same on every machine and with every standard library: SplitMix64.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        return z ^ (z >> 31);
    }

    /// A number between the two.
    double between(double least, double greatest) {
        return least + (greatest - least) * static_cast<double>(bits() >> 11) * 0x1p-53;
    }

private:
    std::uint64_t state_;
};

}  // namespace glassbox
