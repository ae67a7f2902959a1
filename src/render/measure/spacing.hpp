#pragma once
#include <optional>

#include "scene/named.hpp"

namespace glassbox {

/// How values are spaced between the ends of a colour scale.
enum class Spacing {
    linear,
    log,         ///< each power of ten takes as much room; only for values above 0
    symlog,      ///< the same on both sides of 0, and linear around it
    percentile,  ///< each colour stands for as many pixels
};

/// The spacing of a measurement's colours, if the user chose one.
using SetSpacing = std::optional<Spacing>;

inline constexpr NameTable<Spacing, 4> spacings{{
    {"linear", Spacing::linear, "equal differences look equally large"},
    {"log", Spacing::log, "equal ratios do; only for values above 0"},
    {"symlog", Spacing::symlog, "the same on both sides of 0, linear around it"},
    {"percentile", Spacing::percentile, "each colour stands for as many pixels"},
}};

}  // namespace glassbox
