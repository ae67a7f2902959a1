#pragma once
#include <vector>

#include "numerics/assumptions.hpp"

namespace glassbox {

/// The same in this thread, in those that pictures are computed in, and in a new one: each has its own rounding mode
/// and its own word on subnormal numbers.
std::vector<Assumption> try_assumptions_in_threads();

}  // namespace glassbox
