#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "learn/course/workspace.hpp"
#include "learn/picture/written.hpp"
#include "render/setup.hpp"

namespace glassbox {

struct ViewerState;
enum class Beside;

/// All lessons that the learner has finished, at once: all that is written, in any scene.
struct AllLessons {
    bool operator==(const AllLessons&) const = default;
};

/// What of the learner's draws: one lesson, by its number, or all.
using LessonChoice = std::variant<int, AllLessons>;

/// Whose code draws beside ours, and which lessons of it.
struct MineChoice {
    std::filesystem::path folder;                       ///< the learner's; empty: my/ in the project
    std::shared_ptr<const learn::Workspace> workspace;  ///< null: not looked for yet, or not there
    std::string problem;                                ///< why it is not there
    std::optional<LessonChoice> chosen;                 ///< none until `workspace` is there
    std::optional<Options> before;                      ///< what ours was computed by until it was shown
    std::uint64_t saved = 0;                            ///< how often one of the headers has changed since we watch
    bool is_tested = false;                             ///< tests run at each save: the page Mine was opened
    std::string test;                                   ///< the one that is chosen there
    bool is_stepped = false;                            ///< the page Steps goes through its steps, not through ours
};

/// Whether the learner's picture must be computed: it, or its difference from ours, is shown beside ours.
bool shows_mine(const ViewerState& state);

/// Whether the lesson's tests are to be run: those of one lesson at a time.
bool runs_tests(const ViewerState& state);

/// Reads "3", a lesson's number, or "all"; none for anything else.
std::optional<LessonChoice> read_lesson_choice(const std::string& typed);

/// Returns the choice of that lesson, of all, or of the lesson where the learner is. If the lessons, or that lesson, do
/// not exist, `problem` says so.
MineChoice chosen_mine(MineChoice mine, std::optional<LessonChoice> lessons);

/// Shows the learner's picture beside ours, of that lesson, of all, or of the one where the learner is. From then on
/// both are computed in double, so that they differ by the code alone, and at the lesson's stage; undo reverts that,
/// and so does showing something else beside ours.
void show_mine(ViewerState& state, std::optional<LessonChoice> lessons = {});

/// Shows it for what was shown last.
void show_last_mine(ViewerState& state);

/// Shows this beside ours. Where the learner's picture no longer is, ours is computed as it was before that was shown,
/// unless the user has chosen otherwise since.
void show_beside(ViewerState& state, Beside beside);

/// Goes through the steps of the learner's code, of what is chosen or of the lesson where the learner is; or through
/// those of ours.
void step_mine(ViewerState& state, bool on);

/// Shows it for what was shown last, or, if it is shown, nothing beside ours.
void toggle_mine(ViewerState& state);

/// Whether all lessons are chosen, not one.
bool is_of_all(const MineChoice& mine);

/// Returns the one lesson that is chosen; null if there is none, or if all are.
const learn::Exercise* exercise_of(const MineChoice& mine);

/// Returns the lessons whose headers may draw: the one that is chosen, or all that draw in double.
learn::mine::Lessons lessons_of(const MineChoice& mine);

/// Returns the learner's headers of these lessons, whether they exist or not.
std::vector<std::filesystem::path> files_of(const MineChoice& mine);

/// Returns the scalar of our picture beside the learner's: double, as in that one; for the lesson on bounds the truth,
/// which the bounds may never contradict.
Scalar scalar_of(const MineChoice& mine);

/// Returns a setup for looking at what is chosen: in that scalar, at the lesson's stage, or at the last one of all.
Setup for_mine(Setup setup, const MineChoice& mine);

}  // namespace glassbox
