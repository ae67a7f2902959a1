#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "learn/course/workspace.hpp"
#include "render/setup.hpp"

namespace glassbox {

struct ViewerState;

/// Whose code draws beside ours, and which lesson of it.
struct MineChoice {
    std::filesystem::path folder;                       ///< the learner's; empty: my/ in the project
    std::shared_ptr<const learn::Workspace> workspace;  ///< null: not looked for yet, or not there
    std::string problem;                                ///< why it is not there
    int lesson = 0;                                     ///< its number; 0: none yet
    std::uint64_t saved = 0;                            ///< how often one of its headers has changed since we watch
    bool is_tested = false;                             ///< its tests run at each save: the page Mine was opened
    std::string test;                                   ///< the one that is chosen there
};

/// Whether the learner's picture must be computed: it, or its difference from ours, is shown beside ours.
bool shows_mine(const ViewerState& state);

/// Whether the lesson's tests are to be run.
bool runs_tests(const ViewerState& state);

/// Returns the choice of that lesson, or of the one where the learner is. If the lessons, or that lesson, do not exist,
/// `problem` says so.
MineChoice chosen_mine(MineChoice mine, std::optional<int> lesson);

/// Shows the learner's picture beside ours, of that lesson, or of the one where the learner is. From then on both are
/// computed in double, so that they differ by the code alone, and at the lesson's stage; undo reverts that.
void show_mine(ViewerState& state, std::optional<int> lesson = {});

/// Shows it for the lesson that was shown last.
void show_last_mine(ViewerState& state);

/// Shows it for the lesson that was shown last, or, if it is shown, nothing beside ours.
void toggle_mine(ViewerState& state);

/// Returns the lesson whose headers are used; null if there is none.
const learn::Exercise* exercise_of(const MineChoice& mine);

/// Returns the learner's headers of that lesson, whether they exist or not.
std::vector<std::filesystem::path> files_of(const MineChoice& mine);

/// Returns the scalar of our picture beside a lesson's: double, as in that one; for the lesson on bounds the truth,
/// which the bounds may never contradict.
Scalar scalar_of(const learn::Exercise& exercise);

/// Returns a setup for looking at a lesson: in that scalar, at its stage.
Setup for_lesson(Setup setup, const learn::Exercise& exercise);

}  // namespace glassbox
