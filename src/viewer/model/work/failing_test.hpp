#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "learn/told_tests.hpp"

namespace glassbox {

struct ViewerState;
struct Results;

/// A failing test of the learner's whose ray is pinned: it is the scene that is open.
struct LookedAt {
    std::string test;
    std::vector<learn::ToldRow> rows;
    std::filesystem::path before;  ///< the scene that was open
};

/// Chooses a test of the learner's. If it fails with a ray, opens that ray's scene and pins it, by the rule that the
/// test is about.
void look_at(ViewerState& state, const learn::ToldCase& test);

/// Looks at the next failing test after the chosen one, or the one before; around the end to the first.
void look_at_next_failing(ViewerState& state, const Results& results, bool forward);

/// Opens the scene again that was there before a test's ray.
void look_back(ViewerState& state);

/// Returns the rows of a failed test that say what was checked, what it expected and what it got.
std::vector<learn::ToldRow> expected_and_got(const std::vector<learn::ToldRow>& rows);

}  // namespace glassbox
