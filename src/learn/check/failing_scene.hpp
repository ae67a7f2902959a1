#pragma once
#include <optional>
#include <string>
#include <utility>

#include "learn/check/test_run.hpp"

namespace glassbox::learn {

/// A scene in which one pixel's ray is the one that a failed test traced last.
struct FailingScene {
    std::string toml;
    std::pair<int, int> pixel;  ///< x to the right, y down
};

/// Returns the scene of a failure: only its surface, and a parallel view with that ray, to the bit, in the middle of
/// the picture if rounding allows, else in a corner. None if the test traced no ray, or one that no scene can have.
std::optional<FailingScene> failing_scene(const std::string& test, const Failure& failure);

}  // namespace glassbox::learn
