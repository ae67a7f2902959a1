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

/// The result of one test of a lesson.
struct TestedLesson {
    TestRun run;
    Judgement judgement;                       ///< points into `run` and the exercise
    Recognised recognised;                     ///< what the detective says of it
    std::optional<std::pair<int, int>> pixel;  ///< of the failing scene, if one was written
    std::chrono::duration<double> took{};

    TestedLesson() = default;
    TestedLesson(const TestedLesson&) = delete;
    TestedLesson(TestedLesson&&) = default;
    TestedLesson& operator=(TestedLesson&&) = default;
};

/// A learner at work: the workspace and the progress, which is saved at once.
class Learner {
public:
    /// Calls `say` with what takes long, and with what is wrong but need not stop the work. With `is_isolated`, what
    /// the learner wrote is compiled and run isolated.
    Learner(Workspace workspace, std::function<void(const std::string&)> say, bool is_isolated = false);

    const Workspace& workspace() const { return workspace_; }
    const Toolchain& tools();
    const LessonProgress& progress(const Exercise& exercise) { return remembered(exercise); }

    /// Returns the lesson with this number or name; for "" the first that has not been passed, or the last.
    const Exercise& lesson(const std::string& name = "");

    /// Forgets how the lesson's functions stand: it begins anew. Hints and giving up stay remembered.
    void forget(const Exercise& exercise);

    /// Whether the learner's headers are those that were tested last.
    bool is_tested(const Exercise& exercise);

    /// Tests a lesson; makes its starters if they do not exist. Calls `so_far` with what is known already, if the rest
    /// takes longer. Throws Error.
    TestedLesson test(const Exercise& exercise, const std::stop_token& stop = {},
                      std::function<void(const TestRun&)> so_far = {});

    /// Returns the function that a hint would be for: open_function() of the present headers; null if all have passed.
    const Function* next_function(const Exercise& exercise, const std::stop_token& stop = {});

    /// Returns the next hint for a function, from 1 to 3, and remembers it. After the last one it returns the last
    /// again.
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

/// Returns the function to write or correct next: the first that has not passed; those that wait for another come last.
/// Null if all have passed.
const Function* open_function(const Exercise& exercise, const LessonProgress& progress);

/// Returns a fingerprint of a lesson's headers, to notice changes.
std::string fingerprint_of(const Workspace& workspace, const Exercise& exercise);

}  // namespace glassbox::learn
