#pragma once
#include <span>
#include <vector>

#include "render/measure/measurements.hpp"
#include "render/measure/plane.hpp"

namespace glassbox {

/// A measurement and what it measured: as many planes as it has components.
struct Measured {
    const Measurement* what;
    std::span<const Plane> planes;
};

/// The planes of all, in order.
inline std::vector<const Plane*> all_planes(std::span<const Measured> measured) {
    std::vector<const Plane*> planes;
    for (const Measured& m : measured)
        for (const Plane& plane : m.planes) planes.push_back(&plane);
    return planes;
}

}  // namespace glassbox
