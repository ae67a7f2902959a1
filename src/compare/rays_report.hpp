#pragma once
#include <functional>
#include <string>

#include "compare/compare_rays.hpp"

namespace glassbox {

/// What is to be told of a comparison of rays.
struct RaysReport {
    const RayComparison& comparison;
    const Claims& claims;
    Theirs theirs;
    std::size_t worst = 5;                            ///< how many differences to tell
    std::function<std::string(std::size_t)> command;  ///< that shows a ray
    /// How many rounding would not explain in float either, where that was asked, too.
    std::optional<std::size_t> beyond_float = {};
};

/// For a reader: how many differ, how many of these rounding explains; then the worst, and the first.
std::string to_text(const RaysReport& report);

/// For a program: docs/compare.md has the fields.
std::string to_json(const RaysReport& report);

}  // namespace glassbox
