#pragma once
#include <bit>
#include <cstdint>

namespace glassbox {

/// 2 to the exponent of x, an ordinary number.
inline double power_of_two(double x) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0x7FF0'0000'0000'0000);
}
/// Its inverse.
inline double inverse_power_of_two(double power) {
    return std::bit_cast<double>(0x7FE0'0000'0000'0000 - std::bit_cast<std::uint64_t>(power));
}

}  // namespace glassbox
