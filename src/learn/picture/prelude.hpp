#pragma once
// What the learner's renderer includes that is not a formula: precompiled once, since it is the same at every save.
// Never include a header of the core here, as the learner's takes its place.
#include <algorithm>
#include <array>
#include <atomic>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "learn/picture/sheet.hpp"
#include "learn/subprocess/last_words.hpp"
