#pragma once
#include <vector>

#include "numerics/assumptions.hpp"

namespace glassbox {

/// Checks the assumptions in this thread, in the threads that compute pictures, and in a new one: each has its own
/// rounding mode and its own setting for subnormal numbers.
std::vector<Assumption> try_assumptions_in_threads();

}  // namespace glassbox
