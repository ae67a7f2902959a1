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
    std::uint64_t saved = 0;                            ///< how often a header of it has changed since we look
};

/// Whether the learner's picture is to be computed: it, or its difference from ours, stands beside ours.
bool shows_mine(const ViewerState& state);

/// The choice of that lesson, or of the one where the learner is. If the lessons, or that one, are not there, `problem`
/// says so.
MineChoice chosen_mine(MineChoice mine, std::optional<int> lesson);

/// Shows the learner's picture beside ours: of that lesson, or of the one where the learner is. Both are computed in
/// double from then on, so that they differ by the code alone, and at the lesson's stage; undo takes that back.
void show_mine(ViewerState& state, std::optional<int> lesson = {});

/// Shows it, of the lesson that was shown last.
void show_last_mine(ViewerState& state);

/// Shows it so, or shows nothing beside.
void toggle_mine(ViewerState& state);

/// The lesson whose headers are used; null if there is none.
const learn::Exercise* exercise_of(const MineChoice& mine);

/// The learner's headers of that lesson, whether they are there or not.
std::vector<std::filesystem::path> files_of(const MineChoice& mine);

/// What ours is computed in beside a lesson's picture: double, as that; or for the lesson on bounds the truth, which
/// they may never contradict.
Scalar scalar_of(const learn::Exercise& exercise);

/// A setup as a lesson is looked at: in that scalar, at its stage.
Setup for_lesson(Setup setup, const learn::Exercise& exercise);

}  // namespace glassbox
