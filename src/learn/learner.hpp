#pragma once
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

#include "learn/build/toolchain.hpp"
#include "learn/check/detective.hpp"
#include "learn/check/judgement.hpp"
#include "learn/course/progress.hpp"
#include "learn/course/workspace.hpp"

namespace glassbox::learn {

/// What came of one test of a lesson.
struct TestedLesson {
    TestRun run;
    Judgement judgement;                       ///< points into `run` and the exercise
    Recognised recognised;                     ///< the classic mistake that it looks like
    std::optional<std::pair<int, int>> pixel;  ///< of the failing scene, if one was written
    std::chrono::duration<double> took{};

    TestedLesson() = default;
    TestedLesson(const TestedLesson&) = delete;
    TestedLesson(TestedLesson&&) = default;
    TestedLesson& operator=(TestedLesson&&) = default;
};

/// A learner at work: where, and how far. What is remembered is written down at once.
class Learner {
public:
    /// `say` is told what takes long, and what is wrong but need not stop anybody. What the learner wrote is compiled
    /// and run isolated, if asked for.
    Learner(Workspace workspace, std::function<void(const std::string&)> say, bool is_isolated = false);

    const Workspace& workspace() const { return workspace_; }
    const Toolchain& tools();
    const LessonProgress& progress(const Exercise& exercise) { return remembered(exercise); }

    /// The lesson that is asked for, by number or name; of "" the first that has not been passed, or the last.
    const Exercise& lesson(const std::string& name = "");

    /// Whether the learner's headers are what was tested last.
    bool is_tested(const Exercise& exercise);

    /// Tests a lesson; its starters are made if they are not there. `so_far` is told what can be said already, if the
    /// rest takes longer. Throws Error.
    TestedLesson test(const Exercise& exercise, const std::stop_token& stop = {},
                      std::function<void(const TestRun&)> so_far = {});

    /// The function that a hint would be for: open_function() of the headers as they are now; null if all have passed.
    const Function* next_function(const Exercise& exercise, const std::stop_token& stop = {});

    /// The next hint for a function, from 1 to 3; it is remembered. The last one stays the last.
    int next_hint(const Exercise& exercise, const Function& function);

    void remember_giving_up(const Exercise& exercise);

    /// Where the scene of a failed test is.
    std::filesystem::path failing_scene_file() const { return workspace_.hidden() / "failing.toml"; }

private:
    std::filesystem::path progress_file() const { return workspace_.hidden() / "progress.json"; }
    LessonProgress& remembered(const Exercise& exercise) { return progress_.lessons[exercise.name]; }
    void save() const { write_progress(progress_file(), progress_); }

    Workspace workspace_;
    std::function<void(const std::string&)> say_;
    bool is_isolated_;
    Progress progress_;
    std::optional<Toolchain> tools_;
};

/// How a function stands, as it is remembered.
State state_of(const Function& function, const LessonProgress& progress);

/// The function to be written or mended next: the first that has not passed, before those that wait for another. Null
/// if all have passed.
const Function* open_function(const Exercise& exercise, const LessonProgress& progress);

/// What the headers of a lesson are, so that a change is noticed.
std::string fingerprint_of(const Workspace& workspace, const Exercise& exercise);

}  // namespace glassbox::learn
