#pragma once
// What every test of a lesson includes, compiled once for all of a learner's tests: see learn/build/toolchain.hpp. It
// is here and not in tests/ because it belongs to no single test.
#define DOCTEST_CONFIG_SUPER_FAST_ASSERTS
#include <doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <numbers>
#include <optional>
#include <ostream>
#include <random>
#include <sstream>
#include <string>
#include <support/random_bits.hpp>
#include <support/seen.hpp>
#include <support/traced_ray.hpp>
#include <support/ulps.hpp>
#include <utility>
#include <vector>

#include "learn/check/runner/lean_cases.hpp"
