#pragma once
#include <bit>
#include <cstdint>

namespace glassbox {

/// The largest power of two that is not above |x|, a normal number.
inline double power_of_two_below(double x) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0x7FF0'0000'0000'0000);
}
/// 1/power, exactly, for a power of two from 2⁻¹⁰²² to 2¹⁰²².
inline double inverse_power_of_two(double power) {
    return std::bit_cast<double>(0x7FE0'0000'0000'0000 - std::bit_cast<std::uint64_t>(power));
}

}  // namespace glassbox
