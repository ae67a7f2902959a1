#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <stop_token>
#include <string>

#include "learn/build/toolchain.hpp"
#include "learn/course/workspace.hpp"
#include "learn/report/handed_in.hpp"
#include "learn/report/standing.hpp"

namespace glassbox::learn {

/// Whether learners' programs, and the compiler on their files, run isolated (learn/subprocess/isolation.hpp).
enum class Isolating { where_possible, always };

/// Grades learners. Puts the files that it makes in the hidden folder of the teacher's own workspace, and changes
/// nothing in the folders that it looks at.
class Grader {
public:
    /// Calls `say` with what is being done. Throws Error if there is no compiler, or if it must isolate and cannot.
    Grader(Workspace teacher, Isolating isolating, std::function<void(const std::string&)> say);

    /// Why learners' code does not run isolated; "" if it does.
    const std::string& why_not_isolated() const { return why_not_isolated_; }

    /// Returns how a learner stands: tests every lesson begun and draws its picture. Throws Error if the machine cannot
    /// do it, Cancelled when asked to stop.
    LearnerStanding grade(const HandedIn& handed_in, const std::stop_token& stop = {});

private:
    LessonStanding grade(const Workspace& learner, const Exercise& exercise, const std::stop_token& stop);
    const std::optional<Image>& ours(const Exercise& exercise, const std::stop_token& stop);

    Workspace teacher_;
    std::function<void(const std::string&)> say_;
    Toolchain tools_;
    std::string why_not_isolated_;
    std::filesystem::path scratch_;
    std::map<int, std::optional<Image>> ours_;  ///< by the lesson's number
};

}  // namespace glassbox::learn
