#pragma once
#include <cstdint>

namespace glassbox {

/// What a measurement is about, of the side products of all triangles that are tested.
enum class OfSides : std::uint8_t {
    nothing,
    all,            ///< each of them counts
    least,          ///< the least, by size
    least_certain,  ///< the least certain of those that decide
};

}  // namespace glassbox
