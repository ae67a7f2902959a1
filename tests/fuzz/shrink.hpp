#pragma once
#include "routes.hpp"

namespace glassbox::fuzz {

struct Shrunk {
    Drawn drawn;
    Fault fault;
};

/// Returns the smallest scene found in which the route fails in the same way: fewer surfaces, one ray or one pixel,
/// numbers of fewer bits.
Shrunk shrink(const Drawn& drawn, const Fault& fault, const Route& route);

}  // namespace glassbox::fuzz
